"""Transforms that know their frames: camera_T_mri @ mri_T_coil is camera_T_coil; other chains are refused."""

import re

import numpy as np

from .errors import FaceNavError

RIGID_TOLERANCE = 1e-3  # files carry about 6 digits


def rigid_matrix(value, where=""):
    """A 4x4 matrix of a rigid transform, made exactly orthonormal. `value`: 4x4, or 16 numbers row by row."""
    try:
        matrix = np.array(value, dtype=float)
    except (TypeError, ValueError) as fault:
        raise FaceNavError(where, "16 numbers were expected") from fault
    if matrix.shape not in ((4, 4), (16,)):
        raise FaceNavError(where, f"a 4x4 matrix was expected, not the shape {matrix.shape}")
    matrix = matrix.reshape(4, 4)
    if not np.isfinite(matrix).all():
        raise FaceNavError(where, "the matrix holds values that are no numbers")
    rotation = matrix[:3, :3]
    if not np.allclose(matrix[3], [0, 0, 0, 1], atol=RIGID_TOLERANCE):
        raise FaceNavError(where, "the matrix's last row is not 0 0 0 1")
    if not np.allclose(rotation.T @ rotation, np.eye(3), atol=RIGID_TOLERANCE):
        raise FaceNavError(where, "the matrix is no rotation: its axes are not of unit length and at right angles")
    if np.linalg.det(rotation) < 0:
        raise FaceNavError(where, "the matrix is mirrored (determinant -1)")
    u, _, vt = np.linalg.svd(rotation)
    rigid = np.eye(4)
    rigid[:3, :3] = u @ vt
    rigid[:3, 3] = matrix[:3, 3]
    return rigid


def matrix_from_quaternion(translation_mm, wxyz, where=""):
    """4x4 matrix of a translation and a unit quaternion w, x, y, z."""
    q = np.asarray(wxyz, dtype=float)
    length = np.linalg.norm(q)
    if not abs(length - 1) <= 1e-3:
        raise FaceNavError(where, "the quaternion is not of unit length")
    w, x, y, z = q / length
    matrix = np.eye(4)
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                      [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                      [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    matrix[:3, 3] = translation_mm
    return matrix


def quaternion_of(matrix):
    """Unit quaternion w, x, y, z of a 4x4 matrix, w >= 0."""
    r = np.asarray(matrix, dtype=float)[:3, :3]
    # The largest of the four is found from the diagonal, so that no small number is divided by.
    squares = np.array([1 + r[0, 0] + r[1, 1] + r[2, 2], 1 + r[0, 0] - r[1, 1] - r[2, 2],
                        1 - r[0, 0] + r[1, 1] - r[2, 2], 1 - r[0, 0] - r[1, 1] + r[2, 2]])
    k = int(np.argmax(squares))
    columns = [[squares[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
               [r[2, 1] - r[1, 2], squares[1], r[1, 0] + r[0, 1], r[0, 2] + r[2, 0]],
               [r[0, 2] - r[2, 0], r[1, 0] + r[0, 1], squares[2], r[2, 1] + r[1, 2]],
               [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[2, 1] + r[1, 2], squares[3]]]
    q = np.array(columns[k]) / (2 * np.sqrt(squares[k]))
    return q if q[0] >= 0 else -q


class Transform:
    """A rigid transform to_T_from, mm. Frames are names: "mri", "camera", "coil", "head", "marker", "target"."""

    def __init__(self, name, matrix):
        parts = re.fullmatch(r"([a-z]+)_T_([a-z]+)", name)
        if not parts:
            raise FaceNavError("", f"'{name}' names no transform; 'camera_T_mri' was expected")
        self.to, self.of = parts.groups()
        self.matrix = rigid_matrix(matrix, name)

    @property
    def name(self):
        return f"{self.to}_T_{self.of}"

    @property
    def translation_mm(self):
        return self.matrix[:3, 3].copy()

    @property
    def rotation(self):
        return self.matrix[:3, :3].copy()

    def inverse(self):
        return Transform(f"{self.of}_T_{self.to}", np.linalg.inv(self.matrix))

    def renamed(self, name):
        """The same matrix under another name, where two frames are one ("target" is the wanted "coil")."""
        return Transform(name, self.matrix)

    def __matmul__(self, other):
        if not isinstance(other, Transform):
            return NotImplemented
        if self.of != other.to:
            raise FaceNavError("", f"{self.name} @ {other.name} does not fit: {self.of} is not {other.to}")
        return Transform(f"{self.to}_T_{other.of}", self.matrix @ other.matrix)

    def apply(self, points_mm):
        """Points of the frame `of` (3, or n x 3) in the frame `to`."""
        points = np.asarray(points_mm, dtype=float)
        if points.ndim not in (1, 2) or points.shape[-1] != 3:
            raise FaceNavError("", f"points of 3 numbers were expected, not the shape {points.shape}")
        return points @ self.matrix[:3, :3].T + self.matrix[:3, 3]

    def __repr__(self):
        return f"Transform({self.name!r}, translation_mm={self.matrix[:3, 3].round(3).tolist()})"
