"""The names by which programs reach rosbag2_py's classes, and what is refused as pybind11 refuses it."""

from __future__ import annotations

import sys

import pytest
import rosbag2_py

from tests.support.waiting import run


@pytest.mark.process
@pytest.mark.parametrize(
    "line",
    (
        "rosbag2_py._storage.StorageOptions(uri='a', storage_id='sqlite3')",
        "rosbag2_py._storage.ConverterOptions('', '')",
        "rosbag2_py._storage.MetadataIo()",
        "rosbag2_py._transport.RecordOptions().topics",
        "rosbag2_py._transport.bag_rewrite",
        "rosbag2_py._compression_options.CompressionMode.FILE",
        "rosbag2_py._message_definitions.LocalMessageDefinitionSource()",
        "rosbag2_py._info.Info().read_metadata_and_output_service_verbose",
    ),
)
def test_modules_that_programs_name_are_there_after_the_first_import(line):
    program = f"import sys; sys.path[:0] = {sys.path!r}; import rosbag2_py; print({line} is not None)"
    done = run([sys.executable, "-c", program])
    assert (done.stdout, done.stderr) == ("True\n", "")


def test_policies_have_rmws_names():
    from rosbag2_py._storage import QoS, rmw_qos_durability_policy_t, rmw_qos_reliability_policy_t

    profile = QoS(5).reliability(rmw_qos_reliability_policy_t.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)
    profile.durability(rmw_qos_durability_policy_t.RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)
    assert profile == QoS(5).best_effort().transient_local()


@pytest.mark.parametrize(
    ("options", "place"),
    (
        (rosbag2_py.RecordOptions(), "rosbag2_py._transport.RecordOptions"),
        (rosbag2_py.PlayOptions(), "rosbag2_py._transport.PlayOptions"),
        (rosbag2_py.StorageOptions("a"), "rosbag2_py._storage.StorageOptions"),
    ),
)
def test_an_option_that_does_not_exist_is_refused(options, place):
    with pytest.raises(AttributeError, match=f"'{place}' object has no attribute 'all'"):
        options.all = True


def test_options_have_their_old_names_in_humble(monkeypatch):
    from day6_core.ros import differences

    monkeypatch.setattr(differences, "value", lambda key: key == "bag.options_have_old_names")
    options = rosbag2_py.RecordOptions()
    options.all, options.exclude = True, "/rosout"
    assert options.all_topics and options.exclude_regex == "/rosout"


@pytest.mark.parametrize("kind", (rosbag2_py.Player, rosbag2_py.Recorder))
def test_a_log_level_that_does_not_exist_is_refused_at_once(kind):
    kind("debug")
    with pytest.raises(RuntimeError, match="Couldn't parse log level"):
        kind("xxx")
