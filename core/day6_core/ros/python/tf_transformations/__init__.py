"""The ROS package tf_transformations: rotations and homogeneous matrices.

A quaternion is (x, y, z, w), a matrix a numpy array of shape (4, 4), angles are radians. The usual functions, from Euler
angles to quaternions and back, don't import numpy.
"""

from typing import TYPE_CHECKING, Any

from tf_transformations._euler import AXES_TO_TUPLE as _AXES2TUPLE
from tf_transformations._euler import TUPLE_TO_AXES as _TUPLE2AXES
from tf_transformations._euler import euler_from_matrix as euler_from_matrix
from tf_transformations._euler import euler_from_quaternion as euler_from_quaternion
from tf_transformations._euler import euler_matrix as euler_matrix
from tf_transformations._euler import quaternion_from_euler as quaternion_from_euler
from tf_transformations._matrices import clip_matrix as clip_matrix
from tf_transformations._matrices import compose_matrix as compose_matrix
from tf_transformations._matrices import concatenate_matrices as concatenate_matrices
from tf_transformations._matrices import decompose_matrix as decompose_matrix
from tf_transformations._matrices import identity_matrix as identity_matrix
from tf_transformations._matrices import inverse_matrix as inverse_matrix
from tf_transformations._matrices import is_same_transform as is_same_transform
from tf_transformations._matrices import orthogonalization_matrix as orthogonalization_matrix
from tf_transformations._matrices import projection_from_matrix as projection_from_matrix
from tf_transformations._matrices import projection_matrix as projection_matrix
from tf_transformations._matrices import reflection_from_matrix as reflection_from_matrix
from tf_transformations._matrices import reflection_matrix as reflection_matrix
from tf_transformations._matrices import rotation_from_matrix as rotation_from_matrix
from tf_transformations._matrices import rotation_matrix as rotation_matrix
from tf_transformations._matrices import scale_from_matrix as scale_from_matrix
from tf_transformations._matrices import scale_matrix as scale_matrix
from tf_transformations._matrices import shear_from_matrix as shear_from_matrix
from tf_transformations._matrices import shear_matrix as shear_matrix
from tf_transformations._matrices import superimposition_matrix as superimposition_matrix
from tf_transformations._matrices import translation_from_matrix as translation_from_matrix
from tf_transformations._matrices import translation_matrix as translation_matrix
from tf_transformations._quaternions import quaternion_about_axis as quaternion_about_axis
from tf_transformations._quaternions import quaternion_conjugate as quaternion_conjugate
from tf_transformations._quaternions import quaternion_from_matrix as quaternion_from_matrix
from tf_transformations._quaternions import quaternion_inverse as quaternion_inverse
from tf_transformations._quaternions import quaternion_matrix as quaternion_matrix
from tf_transformations._quaternions import quaternion_multiply as quaternion_multiply
from tf_transformations._quaternions import quaternion_slerp as quaternion_slerp
from tf_transformations._quaternions import random_quaternion as random_quaternion
from tf_transformations._quaternions import random_rotation_matrix as random_rotation_matrix
from tf_transformations._trackball import Arcball as Arcball
from tf_transformations._trackball import arcball_constrain_to_axis as arcball_constrain_to_axis
from tf_transformations._trackball import arcball_map_to_sphere as arcball_map_to_sphere
from tf_transformations._trackball import arcball_nearest_axis as arcball_nearest_axis
from tf_transformations._vectors import EPSILON as _EPS
from tf_transformations._vectors import random_vector as random_vector
from tf_transformations._vectors import unit_vector as unit_vector
from tf_transformations._vectors import vector_norm as vector_norm

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    ROTATION_IDENTITY: NDArray[numpy.float64]

__all__ = ["_AXES2TUPLE", "_EPS", "_TUPLE2AXES"]
__all__ += [name for name in dir() if not name.startswith("_") and name not in ("Any", "TYPE_CHECKING")]

TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY


def __getattr__(name: str) -> Any:
    if name == "ROTATION_IDENTITY":
        import numpy

        value = globals()[name] = numpy.identity(3, dtype=numpy.float64)
        return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
