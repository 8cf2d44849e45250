"""Homogeneous matrices, shape (4, 4)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from tf_transformations._euler import euler_from_matrix, rotation_from_euler
from tf_transformations._vectors import EPSILON, unit_vector

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    Array = NDArray[float64]


def _affine(linear: Any = None, offset: Any = None) -> Array:
    import numpy

    matrix = numpy.identity(4)
    if linear is not None:
        matrix[:3, :3] = linear
    if offset is not None:
        matrix[:3, 3] = offset
    return matrix


def _eigenvector(matrix: Any, value: float, tolerance: float, last: bool, message: str) -> Array:
    """Return the first (or last) eigenvector of an eigenvalue. Raises ValueError with `message` if there is none."""
    import numpy

    values, vectors = numpy.linalg.eig(matrix)
    (found,) = numpy.nonzero(abs(numpy.real(values) - value) < tolerance)
    if not len(found):
        raise ValueError(message)
    vector: Array = numpy.real(vectors[:, found[-1 if last else 0]]).squeeze()
    return vector


def identity_matrix() -> Array:
    """Return the identity matrix."""
    return _affine()


def translation_matrix(direction: Any) -> Array:
    """Return the translation by a vector."""
    return _affine(offset=direction)


def translation_from_matrix(matrix: Any) -> Array:
    """Return the translation vector of a matrix."""
    import numpy

    vector: Array = numpy.asarray(matrix)[:3, 3]
    return vector


def reflection_matrix(point: Any, normal: Any) -> Array:
    """Return the reflection in the plane through a point with a normal."""
    import numpy

    unit = unit_vector(normal[:3])
    return _affine(numpy.identity(3) - 2.0 * numpy.outer(unit, unit), 2.0 * numpy.dot(point[:3], unit) * unit)


def reflection_from_matrix(matrix: Any) -> tuple[Array, Array]:
    """Return a point of the reflection's plane and its normal. Raises ValueError for any other matrix."""
    import numpy

    matrix = numpy.asarray(matrix, dtype=numpy.float64)
    linear = matrix[:3, :3]
    normal = _eigenvector(linear, -1.0, 1e-8, False, "no unit eigenvector corresponding to eigenvalue -1")
    if not abs(numpy.linalg.det(linear) + 1.0) < 1e-8:
        raise ValueError("Determinant should be -1")
    return _fixed_point(matrix, "no eigenvector corresponding to eigenvalue 1")[:3], normal


def _fixed_point(matrix: Any, message: str) -> Array:
    point = _eigenvector(matrix, 1.0, 1e-8, True, message)
    moved: Array = point / point[3]
    return moved


def rotation_matrix(angle: float, direction: Any, point: Any = None) -> Array:
    """Return the rotation by an angle (radians) about the axis through a point (by default the origin)."""
    import numpy

    x, y, z = unit_vector(direction[:3])
    c, s = math.cos(angle), math.sin(angle)
    rest = 1.0 - c
    turn = numpy.array(
        [
            [x * x * rest + c, x * y * rest - z * s, z * x * rest + y * s],
            [x * y * rest + z * s, y * y * rest + c, y * z * rest - x * s],
            [z * x * rest - y * s, y * z * rest + x * s, z * z * rest + c],
        ]
    )
    if point is None:
        return _affine(turn)
    centre = numpy.array(point[:3], dtype=numpy.float64)
    return _affine(turn, centre - turn @ centre)


def rotation_from_matrix(matrix: Any) -> tuple[float, Array, Array]:
    """Return angle (radians), axis and a point of the axis (4 numbers). Raises ValueError unless it is a rotation."""
    import numpy

    matrix = numpy.asarray(matrix, dtype=numpy.float64)
    turn = matrix[:3, :3]
    message = "no unit eigenvector corresponding to eigenvalue 1"
    values, vectors = numpy.linalg.eig(turn.T)
    (found,) = numpy.nonzero(abs(values - 1.0) < 1e-5)
    if not len(found):
        raise ValueError(message)
    axis = numpy.real(vectors[:, found[-1]])
    cosine = (numpy.trace(turn) - 1.0) / 2.0
    # The sine follows from the element opposite to a component of the axis that isn't close to 0.
    for component, row, column in ((2, 1, 0), (1, 0, 2), (0, 2, 1)):
        if component == 0 or abs(axis[component]) > 1e-8:
            sine = (turn[row, column] + (cosine - 1.0) * axis[row] * axis[column]) / axis[component]
            break
    return math.atan2(sine, cosine), axis, _fixed_point(matrix, message)


def scale_matrix(factor: float, origin: Any = None, direction: Any = None) -> Array:
    """Return the scaling from a point, in all directions or in one; factor -1 reflects."""
    import numpy

    if direction is None:
        offset = None if origin is None else (1.0 - factor) * numpy.asarray(origin[:3], dtype=numpy.float64)
        return _affine(numpy.diag([factor] * 3), offset)
    unit = unit_vector(direction[:3])
    offset = None if origin is None else (1.0 - factor) * numpy.dot(origin[:3], unit) * unit
    return _affine(numpy.identity(3) - (1.0 - factor) * numpy.outer(unit, unit), offset)


def scale_from_matrix(matrix: Any) -> tuple[float, Array, Array | None]:
    """Return factor, origin and direction (None: all). Raises ValueError for a matrix without a fixed point."""
    import numpy

    matrix = numpy.asarray(matrix, dtype=numpy.float64)
    linear = matrix[:3, :3]
    factor = float(numpy.trace(linear)) - 2.0
    direction = None
    try:
        direction = unit_vector(_eigenvector(linear, factor, 1e-8, False, "the same in all directions"))
    except ValueError:
        factor = (factor + 2.0) / 3.0
    return factor, _fixed_point(matrix, "no eigenvector corresponding to eigenvalue 1")[:3], direction


def projection_matrix(
    point: Any, normal: Any, direction: Any = None, perspective: Any = None, pseudo: bool = False
) -> Array:
    """Return the projection onto a plane: along a direction, from a point (`perspective`), or perpendicular.

    With `pseudo` a perspective projection keeps relative depth.
    """
    import numpy

    matrix = numpy.identity(4)
    point = numpy.array(point[:3], dtype=numpy.float64)
    normal = unit_vector(normal[:3])
    if perspective is not None:
        eye = numpy.array(perspective[:3], dtype=numpy.float64)
        numpy.fill_diagonal(matrix[:3, :3], numpy.dot(eye - point, normal))
        matrix[:3, :3] -= numpy.outer(eye, normal)
        if pseudo:
            matrix[:3, :3] -= numpy.outer(normal, normal)
        matrix[:3, 3] = numpy.dot(point, normal) * (eye + normal if pseudo else eye)
        matrix[3, :3] = -normal
        matrix[3, 3] = numpy.dot(eye, normal)
        return matrix
    along = normal if direction is None else numpy.array(direction[:3], dtype=numpy.float64)
    along = along / numpy.dot(along, normal)
    matrix[:3, :3] -= numpy.outer(along, normal)
    matrix[:3, 3] = along * numpy.dot(point, normal)
    return matrix


def projection_from_matrix(matrix: Any, pseudo: bool = False) -> tuple[Any, Any, Any, Any, bool]:
    """Return the arguments of `projection_matrix`. Raises ValueError unless the matrix is a projection."""
    import numpy

    matrix = numpy.array(matrix, dtype=numpy.float64)
    linear = matrix[:3, :3]
    values, vectors = numpy.linalg.eig(matrix)
    (ones,) = numpy.nonzero(abs(numpy.real(values) - 1.0) < 1e-8)
    if not pseudo and len(ones):
        point = numpy.real(vectors[:, ones[-1]]).squeeze()
        point = point / point[3]
        none = "no eigenvector corresponding to eigenvalue 0"
        direction = unit_vector(_eigenvector(linear, 0.0, 1e-8, False, none))
        try:
            normal = unit_vector(_eigenvector(linear.T, 0.0, 1e-8, False, none))
        except ValueError:
            return point, direction, None, None, False
        return point, normal, direction, None, False
    (others,) = numpy.nonzero(abs(numpy.real(values)) > 1e-8)
    if not len(others):
        raise ValueError("no eigenvector not corresponding to eigenvalue 0")
    point = numpy.real(vectors[:, others[-1]]).squeeze()
    point = point / point[3]
    normal = -matrix[3, :3]
    perspective = matrix[:3, 3] / numpy.dot(point[:3], normal)
    return point, normal, None, perspective - normal if pseudo else perspective, pseudo


def clip_matrix(
    left: float, right: float, bottom: float, top: float, near: float, far: float, perspective: bool = False
) -> Array:
    """Return the matrix that maps a viewing box (or, with `perspective`, a frustum) to the cube from -1 to 1.

    Raises ValueError for a box without volume, or a frustum that begins behind the eye.
    """
    import numpy

    if left >= right or bottom >= top or near >= far:
        raise ValueError("invalid frustrum")
    width, height, depth = right - left, top - bottom, far - near
    matrix = numpy.zeros((4, 4))
    if perspective:
        if near <= EPSILON:
            raise ValueError("invalid frustum: near <= 0")
        matrix[0, [0, 2]] = -2.0 * near / width, (right + left) / width
        matrix[1, [1, 2]] = -2.0 * near / height, (top + bottom) / height
        matrix[2, [2, 3]] = -(far + near) / depth, 2.0 * near * far / depth
        matrix[3, 2] = -1.0
    else:
        matrix[0, [0, 3]] = 2.0 / width, -(right + left) / width
        matrix[1, [1, 3]] = 2.0 / height, -(top + bottom) / height
        matrix[2, [2, 3]] = 2.0 / depth, -(far + near) / depth
        matrix[3, 3] = 1.0
    return matrix


def shear_matrix(angle: float, direction: Any, point: Any, normal: Any) -> Array:
    """Return the shear by an angle (radians) along a direction, for the plane through a point with a normal."""
    import numpy

    unit, along = unit_vector(normal[:3]), unit_vector(direction[:3])
    tangent = math.tan(angle)
    linear = numpy.identity(3) + tangent * numpy.outer(along, unit)
    return _affine(linear, -tangent * numpy.dot(point[:3], unit) * along)


def shear_from_matrix(matrix: Any) -> tuple[float, Array, Array, Array]:
    """Return angle, direction, point and normal of a shear."""
    import numpy

    matrix = numpy.asarray(matrix, dtype=numpy.float64)
    left, sizes, right = numpy.linalg.svd(matrix[:3, :3] - numpy.identity(3))
    tangent, direction, normal = float(sizes[0]), left[:, 0], right[0]
    largest = int(numpy.argmax(abs(direction)))
    distance = matrix[largest, 3] / (tangent * direction[largest])
    return math.atan(tangent), direction, -distance * normal, normal


def split(matrix: Any) -> tuple[Array, Array, Array, Array]:
    """Return translation, rotation, scale and shear, the rotation by Cholesky's decomposition.

    Raises numpy.linalg.LinAlgError for a singular matrix.
    """
    import numpy

    matrix = numpy.asarray(matrix, dtype=numpy.float64)
    linear = matrix[:3, :3]
    stretch = numpy.linalg.cholesky(linear.T @ linear).T
    scale = numpy.diag(stretch).copy()
    shear = (stretch / scale[:, numpy.newaxis])[numpy.triu_indices(3, 1)]
    rotation = linear @ numpy.linalg.inv(stretch)
    if numpy.linalg.det(rotation) < 0:
        scale[0] *= -1
        stretch[0] *= -1
        rotation = linear @ numpy.linalg.inv(stretch)
    return matrix[:3, 3], rotation, scale, shear


def decompose_matrix(matrix: Any) -> tuple[Array, Array, tuple[float, float, float], Array, None]:
    """Return scale, shear, Euler angles (about fixed x, y, z), translation and None (in place of the perspective).

    Raises numpy.linalg.LinAlgError for a singular matrix.
    """
    translation, rotation, scale, shear = split(matrix)
    return scale, shear, euler_from_matrix(rotation), translation, None


def compose_matrix(
    scale: Any = None, shear: Any = None, angles: Any = None, translate: Any = None, perspective: Any = None
) -> Array:
    """Return the matrix that shears, scales, rotates and translates. As in the real package `perspective` has no effect."""
    import numpy

    stretch = numpy.identity(3)
    if shear is not None:
        stretch[numpy.triu_indices(3, 1)] = shear
    if scale is not None:
        stretch = numpy.diag(scale) @ stretch
    if angles is not None:
        stretch = rotation_from_euler(*angles) @ stretch
    return _affine(stretch, translate)


def orthogonalization_matrix(lengths: Any, angles: Any) -> Array:
    """Return the matrix of a crystallographic cell with these edge lengths and angles (degrees)."""
    import numpy

    a, b, c = lengths
    alpha, beta, gamma = numpy.radians(angles)
    sin_a, cos_a = math.sin(alpha), math.cos(alpha)
    sin_b, cos_b = math.sin(beta), math.cos(beta)
    skew = (cos_a * cos_b - math.cos(gamma)) / (sin_a * sin_b)
    linear = [
        [a * sin_b * math.sqrt(1.0 - skew * skew), 0.0, 0.0],
        [-a * sin_b * skew, b * sin_a, 0.0],
        [a * cos_b, b * cos_a, c],
    ]
    return _affine(linear)


def superimposition_matrix(v0: Any, v1: Any, scaling: bool = False, usesvd: bool = True) -> Array:
    """Return the rotation and translation (with `scaling` also a factor) that best map one set of points to another.

    Both have shape (3, n) or (4, n), n at least 3. Kabsch's method, or Horn's without `usesvd`. Raises ValueError.
    """
    import numpy

    v0 = numpy.array(v0, dtype=numpy.float64)[:3]
    v1 = numpy.array(v1, dtype=numpy.float64)[:3]
    if v0.shape != v1.shape or v0.shape[1] < 3:
        raise ValueError("Vector sets are of wrong shape or type.")
    centre0, centre1 = v0.mean(axis=1), v1.mean(axis=1)
    v0 = v0 - centre0[:, numpy.newaxis]
    v1 = v1 - centre1[:, numpy.newaxis]
    if usesvd:
        left, _, right = numpy.linalg.svd(v1 @ v0.T)
        if numpy.linalg.det(left @ right) < 0.0:
            left[:, 2] *= -1.0
        linear = left @ right
    else:
        linear = _horn(v0 @ v1.T)
    if scaling:
        linear = linear * math.sqrt(numpy.sum(v1 * v1) / numpy.sum(v0 * v0))
    return _affine(linear, centre1 - linear @ centre0)


def _horn(s: Any) -> Any:
    """Return the best rotation from the sums of products of coordinates (B. Horn, J. Opt. Soc. Am. A 4, 629, 1987)."""
    import numpy

    from tf_transformations._euler import rotation_rows

    n = numpy.zeros((4, 4))
    n[0, 0] = numpy.trace(s)
    n[0, 1:] = n[1:, 0] = s[1, 2] - s[2, 1], s[2, 0] - s[0, 2], s[0, 1] - s[1, 0]
    n[1:, 1:] = s + s.T - numpy.trace(s) * numpy.identity(3)
    values, vectors = numpy.linalg.eigh(n)
    w, x, y, z = vectors[:, numpy.argmax(values)]
    return numpy.array(rotation_rows((x, y, z, w)))


def inverse_matrix(matrix: Any) -> Array:
    """Return the inverse of a square matrix. Raises numpy.linalg.LinAlgError for a singular one."""
    import numpy

    inverse: Array = numpy.linalg.inv(matrix)
    return inverse


def concatenate_matrices(*matrices: Any) -> Array:
    """Return the product of matrices."""
    import numpy

    product = numpy.identity(4)
    for each in matrices:
        product = numpy.dot(product, each)
    return product


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Return whether two matrices are the same transformation."""
    import numpy

    first = numpy.array(matrix0, dtype=numpy.float64)
    second = numpy.array(matrix1, dtype=numpy.float64)
    return bool(numpy.allclose(first / first[3, 3], second / second[3, 3]))
