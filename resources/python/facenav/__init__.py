"""Cases of FaceNav as numpy arrays: T1, masks, surfaces, targets, sessions, pulses and poses.

Lengths are mm, times s, angles deg. Coordinates are in the frame Mri (RAS, the world of the T1) unless a name
says otherwise; a_T_b maps coordinates in b to coordinates in a. The formats: resources/doc/formats.md.
"""

from .case import Case, Landmark
from .errors import FaceNavError
from .session import Session, read_poses, read_pulses_csv, write_poses, write_pulses_csv
from .surfaces import Surface, read_surface
from .tables import as_pandas
from .targets import Target, planned_pose, read_targets, write_targets
from .transforms import Transform

__all__ = [
    "Case", "FaceNavError", "Landmark", "Session", "Surface", "Target", "Transform", "as_pandas", "planned_pose",
    "read_poses", "read_pulses_csv", "read_surface", "read_targets", "write_poses", "write_pulses_csv", "write_targets",
]
