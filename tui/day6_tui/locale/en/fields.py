"""Fields of messages."""

TEXTS = {
    "fields.request": "Request: Topic",
    "fields.response": "Response: Field",
    "fields.type": "Type",
    "fields.expression": "Expression",
    "fields.value": "Value",
    "fields.edit": "change",
    "fields.take": "take it",
    "fields.on": "and the next field",
    "fields.leave": "old value",
    "fields.next": "next field, while typing",
    "fields.default": "default value",
    "fields.in_force": "in force: {text}",
    "fields.elements": "one element more, less",
}
