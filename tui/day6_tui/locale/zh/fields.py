"""Fields of messages."""

TEXTS = {
    "fields.request": "请求：话题",
    "fields.response": "响应：字段",
    "fields.type": "类型",
    "fields.expression": "表达式",
    "fields.value": "值",
    "fields.edit": "修改",
    "fields.take": "确定",
    "fields.on": "并改下一个",
    "fields.leave": "保留原值",
    "fields.next": "输入时跳到下一个字段",
    "fields.default": "默认值",
    "fields.in_force": "生效的是：{text}",
    "fields.elements": "列表加、减一项",
}
