"""targets.json: the planned poses of the coil."""

import math
from dataclasses import dataclass, field
from pathlib import Path

import json
import numpy as np

from .errors import FaceNavError
from .files import member, numbers_of, read_json, text_of, write_whole
from .transforms import Transform, rigid_matrix

FARTHEST_MM = 1000
LONGEST_NAME, LONGEST_NOTE = 120, 4000  # bytes
_OWN = ("name", "mri_T_target", "cortex_point_mm", "scalp_point_mm", "note")


@dataclass
class Target:
    """A wanted pose of the coil: x, y away from the handle, z into the head; points in Mri, mm."""

    name: str
    mri_T_target: np.ndarray  # 4x4
    cortex_point_mm: np.ndarray
    scalp_point_mm: np.ndarray
    note: str = ""
    more: dict = field(default_factory=dict)  # other keys of the file (locked, dose, changes, ..), kept

    @property
    def is_locked(self):
        return "locked" in self.more

    @property
    def transform(self):
        return Transform("mri_T_target", self.mri_T_target)

    def checked(self, where=""):
        """The target with exact types. Throws if FaceNav would refuse it."""
        _require_words(self.name, LONGEST_NAME, False, f"{where}, name" if where else "the target's name")
        where = f"{where}, target '{self.name}'" if where else f"target '{self.name}'"
        _require_words(self.note, LONGEST_NOTE, True, f"{where}, note")
        matrix = rigid_matrix(self.mri_T_target, f"{where}, mri_T_target")
        points = []
        for key in ("cortex_point_mm", "scalp_point_mm"):
            try:
                point = np.array(getattr(self, key), dtype=float)
            except (TypeError, ValueError) as fault:
                raise FaceNavError(f"{where}, {key}", "3 numbers were expected") from fault
            if point.shape != (3,):
                raise FaceNavError(f"{where}, {key}", "3 numbers were expected")
            points.append(point)
        for what, place in (("pose", matrix[:3, 3]), ("cortex_point_mm", points[0]), ("scalp_point_mm", points[1])):
            if not (np.isfinite(place).all() and np.abs(place).max() <= FARTHEST_MM):
                raise FaceNavError(f"{where}, {what}", "is no place near the head")
        return Target(self.name, matrix, points[0], points[1], self.note, dict(self.more))


def _require_words(text, longest, has_lines, where):
    if not isinstance(text, str):
        raise FaceNavError(where, f"text was expected, not {text!r}")
    try:
        size = len(text.encode("utf-8"))
    except UnicodeEncodeError as fault:
        raise FaceNavError(where, "is not valid Unicode") from fault
    if size > longest:
        raise FaceNavError(where, f"is longer than {longest} bytes")
    if not has_lines and not text.strip(" "):
        raise FaceNavError(where, "is empty")
    for c in text:
        code = ord(c)
        if has_lines and c in "\n\t\r":
            continue
        if code < 0x20 or 0x7F <= code < 0xA0 or code in (0x2028, 0x2029):
            raise FaceNavError(where, "contains a control character")
        if 0x202A <= code <= 0x202E or 0x2066 <= code <= 0x2069:
            raise FaceNavError(where, "contains a mark that turns the reading direction")


def target_from(json_object, where):
    """A target of targets.json or of a pulse."""
    if not isinstance(json_object, dict):
        raise FaceNavError(where, "a target was expected")
    numbers = {key: numbers_of(member(json_object, key, where), count, f"{where}, {key}")
               for key, count in (("mri_T_target", 16), ("cortex_point_mm", 3), ("scalp_point_mm", 3))}
    more = {key: value for key, value in json_object.items() if key not in _OWN}
    return Target(text_of(member(json_object, "name", where), f"{where}, name"), np.array(numbers["mri_T_target"]),
                  np.array(numbers["cortex_point_mm"]), np.array(numbers["scalp_point_mm"]),
                  text_of(json_object.get("note", ""), f"{where}, note"), more).checked(where)


def _unique(targets, where):
    names = set()
    for target in targets:
        if target.name in names:
            raise FaceNavError(where, f"two targets have the name '{target.name}'")
        names.add(target.name)
    return targets


def read_targets(path):
    """The targets of a targets.json; none if the file is absent."""
    path = Path(path)
    if not path.exists():
        return []
    listed = member(read_json(path), "targets", path)
    if not isinstance(listed, list):
        raise FaceNavError(path, "'targets' is no list")
    return _unique([target_from(one, f"{path}, targets[{n}]") for n, one in enumerate(listed)], path)


def write_targets(targets, path):
    """Writes the whole file. Keys of other tools beside 'targets' are kept. Throws, and changes nothing, if a target is
    not sound, or if a locked target of the file would be changed or dropped."""
    path = Path(path)
    targets = _unique([target.checked() for target in targets], path)
    content = read_json(path) if path.exists() else {}
    by_name = {target.name: target for target in targets}
    for old in read_targets(path):
        new = by_name.get(old.name)
        if old.is_locked and (new is None or not np.allclose(new.mri_T_target, old.mri_T_target, atol=1e-6)):
            raise FaceNavError(path, f"the target '{old.name}' is locked")
    content["targets"] = [_json_of(target) for target in targets]
    try:
        text = json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)
    except (TypeError, ValueError) as fault:
        raise FaceNavError(path, f"a target's further keys are no JSON ({fault})") from fault
    write_whole(path, text + "\n")


def _json_of(target):
    return {"name": target.name, "mri_T_target": target.mri_T_target.reshape(16).tolist(),
            "cortex_point_mm": target.cortex_point_mm.tolist(), "scalp_point_mm": target.scalp_point_mm.tolist(),
            "note": target.note, **target.more}


def planned_pose(scalp_point_mm, cortex_point_mm, handle_mm):
    """mri_T_target of a coil that lies at the scalp point, its z towards the cortex point, its handle towards the
    direction `handle_mm` (from the coil to the hand). For a plate that rests on the head use `facenav plan`."""
    origin = np.asarray(scalp_point_mm, dtype=float)
    z = np.asarray(cortex_point_mm, dtype=float) - origin
    y = -np.asarray(handle_mm, dtype=float)
    if not (z.shape == y.shape == (3,) and np.isfinite(z).all() and np.isfinite(y).all()):
        raise FaceNavError("", "two points and a direction of 3 numbers were expected")
    if np.linalg.norm(z) < 1e-6:
        raise FaceNavError("", "scalp point and cortex point are one")
    z = z / np.linalg.norm(z)
    y = y - z * (y @ z)
    if not math.isfinite(np.linalg.norm(y)) or np.linalg.norm(y) < 1e-6:
        raise FaceNavError("", "the handle lies along the coil's axis")
    y = y / np.linalg.norm(y)
    pose = np.eye(4)
    pose[:3, :3] = np.column_stack([np.cross(y, z), y, z])
    pose[:3, 3] = origin
    return pose
