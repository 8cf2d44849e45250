"""Requests and responses between a local endpoint and Zenoh.

A server is a queryable; a request is a query to all of them, identified by the client's GID and its sequence number,
and each response is a reply with the same two.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import Client, RequestId, Service
from day6_core.interfaces import deserialize, serialize
from day6_core.link.attachment import pack, unpack
from day6_core.link.classes import service_class
from day6_core.link.engine import engine_of
from day6_core.link.engine_thread import callback
from day6_core.link.gid import gid_of
from day6_core.link.keys import data_key, endpoint_token
from day6_core.link.limits import Refusals
from day6_core.link.paths import LinkError
from day6_core.link.topics import Report

if TYPE_CHECKING:
    import zenoh

_FOREVER = 10 * 365 * 24 * 3600.0
"""Seconds. A service may take any time (as an action's result does), but Zenoh requires a limit."""
_RETRY_AFTER = (0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Seconds after which a request that found no server is sent again."""
_MOST_OPEN_REQUESTS = 5000
"""Of one server. The oldest are dropped first: their clients get no response, as with a lost request."""


class Services:
    """Carries requests between clients and servers of different processes, and the responses back."""

    def __init__(self, session: zenoh.Session, zid: str, report: Report, refusals: Refusals) -> None:
        self._session: zenoh.Session | None = session
        self._zid = zid
        self._report = report
        self._refusals = refusals
        # Reentrant: a garbage collection may withdraw an endpoint in the middle of anything.
        self._lock = threading.RLock()
        self._open_requests: dict[Service, dict[RequestId, zenoh.Query]] = {}
        self._clients: dict[Client, tuple[bytes, zenoh.CancellationToken]] = {}

    def serve(self, service: Service) -> Any:
        """Receive requests for a local server from now on, until `undeclare()` of the returned queryable."""
        session = self._open_session()
        engine = engine_of(session)
        self._open_requests[service] = {}
        return session.declare_queryable(
            data_key(service),
            engine.handlers.Callback(callback(self._receiver(service)), indirect=False),
            complete=True,
            allowed_origin=engine.Locality.REMOTE,
        )

    def send_response(self, service: Service, request_id: RequestId, response: Any) -> None:
        """Reply to a request that came by Zenoh; does nothing for any other, or one replied to already."""
        with self._lock:
            query = self._open_requests.get(service, {}).pop(request_id, None)
        if query is None:
            return
        attachment = pack(request_id.sequence_number, service.node.graph.now_ns(), request_id.client_gid)
        with query:
            query.reply(data_key(service), serialize(response), attachment=attachment)

    def send_request(self, client: Client, request: Any, number: int) -> None:
        """Send a request to all remote servers; their responses arrive at `client`."""
        gid, _ = self._open_client(client)
        self._send(client, serialize(request), pack(number, client.node.graph.now_ns(), gid), 0)

    def _send(self, client: Client, payload: bytes, attachment: bytes, attempt: int) -> None:
        session = self._open_session()
        engine = engine_of(session)
        answered = False

        def receive(reply: zenoh.Reply) -> None:
            nonlocal answered
            answered = True
            self._take_reply(client, reply)

        def done() -> None:
            # Between machines, and on slow ones, a server's token may arrive before the route to it is known, and a query
            # that finds nobody ends at once: retry while there is a server.
            if answered or attempt == len(_RETRY_AFTER) or self._session is None or not _has_remote_server(client):
                return
            timer = threading.Timer(_RETRY_AFTER[attempt], self._retry, (client, payload, attachment, attempt + 1))
            timer.daemon = True
            timer.start()

        _, cancellation = self._open_client(client)
        session.get(
            data_key(client),
            engine.handlers.Callback(callback(receive), callback(done), indirect=False),
            target=engine.QueryTarget.ALL_COMPLETE,
            consolidation=engine.ConsolidationMode.NONE,
            congestion_control=engine.CongestionControl.BLOCK,
            # A queue of their own: requests and responses do not wait behind messages.
            priority=engine.Priority.INTERACTIVE_HIGH,
            timeout=_FOREVER,
            payload=payload,
            attachment=attachment,
            allowed_destination=engine.Locality.REMOTE,
            cancellation_token=cancellation,
        )

    def _retry(self, client: Client, payload: bytes, attachment: bytes, attempt: int) -> None:
        if self._session is None or not _has_remote_server(client):
            return
        try:
            self._send(client, payload, attachment, attempt)
        except Exception as error:
            self._report(f"a request to {client.topic} was lost", error)

    def close(self) -> None:
        """Drop the session and all open requests, received or sent; nothing is retried."""
        with self._lock:
            self._session = None
            requests, self._open_requests = self._open_requests, {}
            self._clients.clear()
        for of_one_server in requests.values():
            for query in of_one_server.values():
                query.drop()

    def _open_session(self) -> zenoh.Session:
        if self._session is None:
            raise LinkError("the link was closed")
        return self._session

    def withdraw(self, endpoint: Service | Client) -> None:
        """Forget a server or a client with its open requests."""
        if isinstance(endpoint, Client):
            with self._lock:
                opened = self._clients.pop(endpoint, None)
            if opened is not None:
                opened[1].cancel()
            return
        with self._lock:
            requests = self._open_requests.pop(endpoint, {})
        for query in requests.values():
            query.drop()

    def _open_client(self, client: Client) -> tuple[bytes, zenoh.CancellationToken]:
        with self._lock:
            opened = self._clients.get(client)
            if opened is None:
                gid = gid_of(endpoint_token(client, self._zid))
                opened = self._clients[client] = (gid, engine_of(self._open_session()).CancellationToken())
            return opened

    def _receiver(self, service: Service) -> Callable[[zenoh.Query], None]:
        request_class: type | None = None

        def receive(query: zenoh.Query) -> None:
            # Runs on Zenoh's thread: nothing here may block, and no exception may escape.
            nonlocal request_class
            try:
                if query.attachment is None or query.payload is None:
                    query.drop()
                    return
                number, _, gid = unpack(query.attachment.to_bytes())
                if request_class is None:
                    request_class = service_class(service.type_name).Request
                request = deserialize(query.payload.to_bytes(), request_class)
                request_id = RequestId(gid, number)
                if self._remember(service, request_id, query):
                    service.receive(request, request_id)
            except Exception as error:
                query.drop()
                self._refusals.add("messages")
                self._report(f"a request to {service.topic} was lost", error)

        return receive

    def _remember(self, service: Service, request_id: RequestId, query: zenoh.Query) -> bool:
        """Keep a request until its response is sent; return whether it is a new one."""
        oldest = None
        with self._lock:
            requests = self._open_requests.get(service)
            new = requests is not None and request_id not in requests
            if requests is not None and new:
                if len(requests) >= _MOST_OPEN_REQUESTS:
                    oldest = requests.pop(next(iter(requests)))
                requests[request_id] = query
        if oldest is not None:
            oldest.drop()
        if not new:
            query.drop()
        return new

    def _take_reply(self, client: Client, reply: zenoh.Reply) -> None:
        try:
            sample = reply.ok
            if sample is None or sample.attachment is None or client.destroyed:
                return
            number, _, _ = unpack(sample.attachment.to_bytes())
            response_class = service_class(client.type_name).Response
            client.receive(deserialize(sample.payload.to_bytes(), response_class), number)
        except Exception as error:
            self._refusals.add("messages")
            self._report(f"a response of {client.topic} was lost", error)


def _has_remote_server(client: Client) -> bool:
    return not client.destroyed and any(service.origin is not None for service in client.matched)
