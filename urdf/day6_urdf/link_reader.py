"""Reads <link> and <material> with urdfdom 4.0.1's messages; the numbers are line numbers in its link.cpp."""

from __future__ import annotations

from collections.abc import Callable

from day6_urdf.diagnostics import CAPSULES, Diagnostics, Refused
from day6_urdf.model import (
    Box,
    Capsule,
    Collision,
    Cylinder,
    Geometry,
    Inertial,
    Link,
    Material,
    Mesh,
    Pose,
    Sphere,
    Vector,
    Visual,
)
from day6_urdf.values import ParseError, to_color, to_double, to_vector
from day6_urdf.xmlreader import Element

_INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def read_material(element: Element, diagnostics: Diagnostics, only_name_is_ok: bool) -> tuple[Material, bool]:
    """Return the material and whether it defines anything (a colour or a texture)."""
    name = element.attributes.get("name")
    if name is None:
        diagnostics.error("link", 64, "Material must contain a name attribute", element)
        return Material(""), False
    texture_element = element.first("texture")
    texture = texture_element.attributes.get("filename") if texture_element else None
    color = None
    color_element = element.first("color")
    if color_element is not None and "rgba" in color_element.attributes:
        try:
            color = to_color(color_element.attributes["rgba"])
        except ParseError as error:
            diagnostics.error("link", 93, f"Material [{name}] has malformed color rgba values: {error}", color_element)
    defined = color is not None or texture is not None
    if not defined and not only_name_is_ok:
        diagnostics.error("link", 101, f"Material [{name}] color has no rgba", element)
        diagnostics.error("link", 102, f"Material [{name}] not defined in file", element)
    return Material(name, color, texture), defined


def read_link(element: Element, diagnostics: Diagnostics) -> tuple[Link, bool]:
    """Return the parts of the link that could be read: urdfdom 4 reports an error, drops the rest of the link and goes on.

    The second value is whether urdfdom has the first visual twice, once by itself and once in the list: it has unless reading
    stopped before the end of the visuals.
    """
    name = element.attributes.get("name")
    if name is None:
        diagnostics.error("link", 423, "No name given for the link.", element)
        return Link(""), False
    complete = False
    inertial: Inertial | None = None
    visuals: list[Visual] = []
    collisions: list[Collision] = []
    inertial_element = element.first("inertial")
    try:
        if inertial_element is not None:
            # A malformed <inertial> still counts as one, which is all that kdl_parser's warning about the root checks.
            inertial = Inertial()
            what, number = "inertial", 435
            inertial = _read_inertial(inertial_element, diagnostics)
        what, number = "visual", 453
        for child in element.all("visual"):
            visuals.append(_read_visual(child, diagnostics))
        complete = bool(visuals)
        what, number = "collision", 475
        for child in element.all("collision"):
            collisions.append(_read_collision(child, diagnostics))
    except Refused:
        diagnostics.error("link", number, f"Could not parse {what} element for Link [{name}]", element)
    return Link(name, tuple(visuals), tuple(collisions), inertial), complete


def _read_visual(element: Element, diagnostics: Diagnostics) -> Visual:
    origin = _read_origin(element, diagnostics)
    geometry = _read_geometry(element.first("geometry"), diagnostics)
    name = element.attributes.get("name", "")
    material_element = element.first("material")
    if material_element is None:
        return Visual(geometry, origin, name)
    if "name" not in material_element.attributes:
        raise diagnostics.refuse("link", 375, "Visual material must contain a name attribute", material_element)
    material, defined = read_material(material_element, diagnostics, only_name_is_ok=True)
    return Visual(geometry, origin, name, material.name, material if defined else None)


def _read_collision(element: Element, diagnostics: Diagnostics) -> Collision:
    origin = _read_origin(element, diagnostics)
    return Collision(_read_geometry(element.first("geometry"), diagnostics), origin, element.attributes.get("name", ""))


def _read_origin(element: Element, diagnostics: Diagnostics) -> Pose:
    origin = element.first("origin")
    return Pose() if origin is None else diagnostics.pose(origin)


def _read_geometry(element: Element | None, diagnostics: Diagnostics) -> Geometry:
    if element is None:
        raise Refused("no geometry")  # urdfdom has no message for it either
    if not element.children:
        raise diagnostics.refuse("link", 227, "Geometry tag contains no child element.", element)
    shape = element.children[0]
    reader = _SHAPES.get(shape.tag)
    if reader is None or (reader is _read_capsule and diagnostics.newest < CAPSULES):
        raise diagnostics.refuse("link", 262, f"Unknown geometry type '{shape.tag}'", shape)
    return reader(shape, diagnostics)


def _read_sphere(shape: Element, diagnostics: Diagnostics) -> Sphere:
    if "radius" not in shape.attributes:
        raise diagnostics.refuse("link", 117, "Sphere shape must have a radius attribute", shape)
    return Sphere(_number(shape, "radius", 126, diagnostics))


def _read_box(shape: Element, diagnostics: Diagnostics) -> Box:
    if "size" not in shape.attributes:
        raise diagnostics.refuse("link", 140, "Box shape has no size attribute", shape)
    return Box(_vector(shape, "size", 150, diagnostics))


def _read_cylinder(shape: Element, diagnostics: Diagnostics) -> Cylinder:
    if "length" not in shape.attributes or "radius" not in shape.attributes:
        raise diagnostics.refuse("link", 164, "Cylinder shape must have both length and radius attributes", shape)
    length = _number(shape, "length", 173, diagnostics)
    return Cylinder(_number(shape, "radius", 182, diagnostics), length)


def _read_capsule(shape: Element, diagnostics: Diagnostics) -> Capsule:
    if diagnostics.version < CAPSULES:
        text = "Ignoring capsule attribute minimum required version URDF version 1.1 since specified version is 1.0."
        diagnostics.warning("link", 297, text, shape)
        raise Refused(text)
    if "length" not in shape.attributes or "radius" not in shape.attributes:
        raise diagnostics.refuse("link", 227, "Capsule shape must have both length and radius attributes", shape)
    length = _number(shape, "length", 236, diagnostics)
    return Capsule(_number(shape, "radius", 245, diagnostics), length)


def _read_mesh(shape: Element, diagnostics: Diagnostics) -> Mesh:
    if "filename" not in shape.attributes:
        raise diagnostics.refuse("link", 196, "Mesh must contain a filename attribute", shape)
    filename = shape.attributes["filename"]
    if "scale" not in shape.attributes:
        return Mesh(filename)
    return Mesh(
        filename, _vector(shape, "scale", 208, diagnostics, "Mesh scale was specified, but could not be parsed: ")
    )


_SHAPES: dict[str, Callable[[Element, Diagnostics], Geometry]] = {
    "sphere": _read_sphere,
    "box": _read_box,
    "capsule": _read_capsule,
    "cylinder": _read_cylinder,
    "mesh": _read_mesh,
}


def _read_inertial(element: Element, diagnostics: Diagnostics) -> Inertial:
    origin = _read_origin(element, diagnostics)
    mass_element = element.first("mass")
    if mass_element is None:
        raise diagnostics.refuse("link", 284, "Inertial element must have a mass element", element)
    if "value" not in mass_element.attributes:
        raise diagnostics.refuse("link", 289, "Inertial: mass element must have value attribute", mass_element)
    value = mass_element.attributes["value"]
    try:
        mass = to_double(value)
    except ParseError as error:
        raise diagnostics.refuse("link", 299, f"Inertial: mass [{value}] is not a float", mass_element) from error
    inertia_element = element.first("inertia")
    if inertia_element is None:
        raise diagnostics.refuse("link", 306, "Inertial element must have inertia element", element)
    moments = []
    for name in _INERTIA:
        if name not in inertia_element.attributes:
            raise diagnostics.refuse(
                "link", 325, f"Inertial: inertia element missing {name} attribute", inertia_element
            )
        try:
            moments.append(to_double(inertia_element.attributes[name]))
        except ParseError as error:
            text = f"Inertial: inertia element {name} is not a valid double"
            raise diagnostics.refuse("link", 334, text, inertia_element) from error
    ixx, ixy, ixz, iyy, iyz, izz = moments
    return Inertial(mass, (ixx, ixy, ixz, iyy, iyz, izz), origin)


def _number(shape: Element, name: str, source_line: int, diagnostics: Diagnostics) -> float:
    text = shape.attributes[name]
    try:
        return to_double(text)
    except ParseError as error:
        raise diagnostics.refuse("link", source_line, f"{name} [{text}] is not a valid float", shape) from error


def _vector(shape: Element, name: str, source_line: int, diagnostics: Diagnostics, before: str = "") -> Vector:
    try:
        return to_vector(shape.attributes[name])
    except ParseError as error:
        raise diagnostics.refuse("link", source_line, f"{before}{error}", shape) from error
