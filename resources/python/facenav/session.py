"""Sessions of a case: poses, guidance, pulses and events as tables."""

import math
from pathlib import Path

import numpy as np

from .errors import FaceNavError
from .files import (csv_integer, csv_number, csv_required, csv_text, member, number_of, number_text, numbers_of,
                    read_csv, read_json, read_json_lines, text_of, write_whole)
from .tables import require_columns, table_of
from .targets import target_from
from .transforms import Transform, matrix_from_quaternion, quaternion_of, rigid_matrix

_POSE = ("tx", "ty", "tz", "qw", "qx", "qy", "qz")
_HEADER = ("frame", "t_s", "object", "status", *_POSE)
_GUIDANCE_NUMBERS = ("distance_mm", "lateral_mm", "depth_mm", "tilt_deg", "twist_deg", "beam_miss_mm",
                     "predicted_error_mm", "gap_mm", "gap_stereo_mm")
_PULSE_NUMBERS = ("distance_mm", "lateral_mm", "depth_mm", "tilt_deg", "twist_deg", "gap_mm", "predicted_error_mm",
                  "intensity_pct", "e_target_v_per_m", "mep_uv", "latency_ms")
_PULSE_TEXTS = ("utc", "source", "target", "status", "reason", "note", "coil")
_DECIMALS = {"t_s": 6, "e_target_v_per_m": 2, "mep_uv": 1, "latency_ms": 2, "intensity_pct": 1}

POSE_COLUMNS = (("frame", "i8"), ("t_s", "f8"), ("object", "U"), ("status", "U"), ("pose", "f8", (4, 4)),
                ("quality", "f8"), ("reason", "U"), ("of_frame", "U"), ("detail", "U"))
GUIDANCE_COLUMNS = (("frame", "i8"), ("t_s", "f8"), ("target", "U"), ("state", "U"),
                    *((name, "f8") for name in _GUIDANCE_NUMBERS))
PULSE_COLUMNS = (("pulse", "i4"), ("t_s", "f8"), ("utc", "U"), ("source", "U"), ("target", "U"), ("status", "U"),
                 ("reason", "U"), ("mri_T_coil", "f8", (4, 4)), *((name, "f8") for name in _PULSE_NUMBERS),
                 ("excluded", "?"), ("note", "U"), ("coil", "U"), ("in_pause", "?"))
_NO_POSE = np.full((4, 4), math.nan)


def _pose_in(row, where):
    return matrix_from_quaternion([csv_required(row, key, where) for key in _POSE[:3]],
                                  [csv_required(row, key, where) for key in _POSE[3:]], where)


def _pose_text(matrix):
    """The fields of a pose; empty ones for an unknown pose."""
    if not np.isfinite(matrix).all():
        return [""] * 7
    return [f"{v:.6f}" for v in matrix[:3, 3]] + [f"{v:.9f}" for v in quaternion_of(matrix)]


def read_poses(path):
    """poses.csv as a structured array (POSE_COLUMNS). `pose`: camera_T_<of_frame>, NaN while lost; `of_frame`: "mri",
    "head", "coil" or "marker", empty in files that do not state it."""
    rows = []
    for n, row in enumerate(read_csv(path, (*_HEADER, "quality", "reason")), 1):
        where = f"{path}, row {n}"
        if row["object"] not in ("head", "coil"):
            raise FaceNavError(where, f"object must be head or coil, not '{row['object']}'")
        if row["status"] not in ("tracked", "lost"):
            raise FaceNavError(where, f"status must be tracked or lost, not '{row['status']}'")
        quality = csv_number(row, "quality", where)
        rows.append({"frame": csv_integer(row, "frame", where), "t_s": csv_required(row, "t_s", where),
                     "object": row["object"], "status": row["status"],
                     "pose": _pose_in(row, where) if row["status"] == "tracked" else _NO_POSE,
                     "quality": 0 if math.isnan(quality) else quality, "reason": row["reason"],
                     "of_frame": row.get("of_frame", ""), "detail": row.get("detail", "")})
    return table_of(rows, POSE_COLUMNS)


def write_poses(table, path):
    """Writes poses (POSE_COLUMNS) as poses.csv, which `facenav guide` reads. A lost row has no pose."""
    rows = []
    for row in require_columns(table, POSE_COLUMNS, "poses"):
        is_tracked = row["status"] == "tracked"
        if is_tracked:
            rigid_matrix(row["pose"], f"pose of frame {row['frame']}")
        rows.append([int(row["frame"]), f"{row['t_s']:.6f}", row["object"], row["status"],
                     *_pose_text(row["pose"] if is_tracked else _NO_POSE), f"{row['quality']:.4f}", row["reason"],
                     row["of_frame"], row["detail"]])
    write_whole(path, csv_text((*_HEADER, "quality", "reason", "of_frame", "detail"), rows))


def read_pulses_csv(path):
    """pulses.csv, as `facenav pulses` writes it, as a structured array (PULSE_COLUMNS)."""
    rows = []
    for n, row in enumerate(read_csv(path, ("pulse", "t_s", "utc", "target", "status", *_POSE)), 1):
        where = f"{path}, row {n}"
        pulse = {"pulse": csv_integer(row, "pulse", where), "t_s": csv_number(row, "t_s", where),
                 "mri_T_coil": _pose_in(row, where) if row["tx"] else _NO_POSE}
        pulse.update({name: row.get(name, "") for name in _PULSE_TEXTS})
        pulse.update({name: csv_number(row, name, where) for name in _PULSE_NUMBERS})
        pulse.update({name: row.get(name, "") == "1" for name in ("excluded", "in_pause")})
        rows.append(pulse)
    return table_of(rows, PULSE_COLUMNS)


def write_pulses_csv(table, path):
    """Writes pulses (PULSE_COLUMNS) as pulses.csv, which `facenav import` reads."""
    rows = []
    for row in require_columns(table, PULSE_COLUMNS, "pulses"):
        if np.isfinite(row["mri_T_coil"]).all():
            rigid_matrix(row["mri_T_coil"], f"pose of pulse {row['pulse']}")
        rows.append([int(row["pulse"]), number_text(row["t_s"], 6), row["utc"], row["source"], row["target"],
                     row["status"], row["reason"], *_pose_text(row["mri_T_coil"]),
                     *(number_text(row[name], _DECIMALS.get(name, 3)) for name in _PULSE_NUMBERS),
                     int(row["excluded"]), row["note"], row["coil"], int(row["in_pause"])])
    header = ("pulse", "t_s", "utc", "source", "target", "status", "reason", *_POSE, *_PULSE_NUMBERS, "excluded",
              "note", "coil", "in_pause")
    write_whole(path, csv_text(header, rows))


class Session:
    """A session's folder. Its files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise FaceNavError(folder, "is no session's folder")

    @property
    def name(self):
        return self.folder.name

    def poses(self, of=None):
        """poses.csv; `of`: "head" or "coil", None for both. Empty where there is no such file (imported pulses)."""
        if of not in (None, "head", "coil"):
            raise FaceNavError(self.folder, f"'{of}' is neither head nor coil")
        path = self.folder / "poses.csv"
        table = read_poses(path) if path.exists() else table_of([], POSE_COLUMNS)
        return table if of is None else table[table["object"] == of]

    def guidance(self):
        """guidance.csv as a structured array; values are NaN where unknown. Empty where there is no such file."""
        path = self.folder / "guidance.csv"
        rows = []
        if not path.exists():
            return table_of(rows, GUIDANCE_COLUMNS)
        for n, row in enumerate(read_csv(path, ("frame", "t_s", "target", "state", *_GUIDANCE_NUMBERS[:7])), 1):
            where = f"{path}, row {n}"
            rows.append({"frame": csv_integer(row, "frame", where), "t_s": csv_required(row, "t_s", where),
                         "target": row["target"], "state": row["state"],
                         **{name: csv_number(row, name, where) for name in _GUIDANCE_NUMBERS}})
        return table_of(rows, GUIDANCE_COLUMNS)

    def events(self):
        """events.jsonl and notes.jsonl as dicts: utc, event, detail."""
        return [line for name in ("events.jsonl", "notes.jsonl") if (self.folder / name).exists()
                for line in read_json_lines(self.folder / name)]

    def pulse_records(self):
        """pulses.jsonl as dicts, as each was kept at its moment, without later edits."""
        path = self.folder / "pulses.jsonl"
        return read_json_lines(path) if path.exists() else []

    def pulses(self):
        """Pulses with the edits made since (exclusions, MEPs), as a structured array (PULSE_COLUMNS)."""
        path = self.folder / "pulses.jsonl"
        pulses = {}
        for n, record in enumerate(self.pulse_records(), 1):
            pulse = _pulse_from(record, f"{path}, pulse {n}")
            pulses.setdefault(pulse["pulse"], pulse)
        _apply_edits(self.folder / "pulse_edits.jsonl", pulses)
        return table_of(list(pulses.values()), PULSE_COLUMNS)

    def targets_of_pulses(self):
        """Targets as they were when pulses were given, by name; the last one where a target was changed."""
        path = self.folder / "pulses.jsonl"
        return {record["target"].get("name"): target_from(record["target"], path)
                for record in self.pulse_records() if "target" in record}

    def times(self):
        """times.json as a dict (s); empty in older sessions."""
        path = self.folder / "times.json"
        return read_json(path) if path.exists() else {}

    def transform(self, row):
        """A row of poses() as a transform with its frames: camera_T_mri, camera_T_coil, .."""
        if row["status"] != "tracked":
            raise FaceNavError(self.folder, f"frame {row['frame']} has no pose of the {row['object']}: {row['reason']}")
        if not row["of_frame"]:
            raise FaceNavError(self.folder, "the file does not state the pose's frame; make a Transform with its name")
        return Transform(f"camera_T_{row['of_frame']}", row["pose"])

    def __repr__(self):
        return f"Session({self.name!r})"


def _pulse_from(record, where):
    pulse = {name: text_of(record.get(name, ""), f"{where}, {name}") for name in _PULSE_TEXTS if name != "target"}
    pulse.update({name: number_of(record[name], f"{where}, {name}") if name in record else math.nan
                  for name in ("t_s", *_PULSE_NUMBERS)})
    if pulse["status"] not in ("on_target", "outside", "lost"):
        raise FaceNavError(where, f"on_target, outside or lost was expected, not '{pulse['status']}'")
    pulse["pulse"] = int(number_of(member(record, "pulse", where), where))
    pulse["target"] = target_from(record["target"], where).name if "target" in record else ""
    pulse["in_pause"] = record.get("in_pause", 0) != 0
    pulse["excluded"] = False
    pulse["mri_T_coil"] = _NO_POSE
    if "camera_T_mri" in record and "camera_T_coil" in record:
        camera_T_mri, camera_T_coil = (Transform(name, numbers_of(record[name], 16, f"{where}, {name}"))
                                       for name in ("camera_T_mri", "camera_T_coil"))
        pulse["mri_T_coil"] = (camera_T_mri.inverse() @ camera_T_coil).matrix
    return pulse


def _apply_edits(path, pulses):
    for edit in read_json_lines(path) if path.exists() else ():
        pulse = pulses.get(member(edit, "pulse", path))
        change = member(edit, "change", path)
        if pulse is None:
            continue
        if change == "mep":
            for name in ("mep_uv", "latency_ms"):
                pulse[name] = number_of(edit[name], f"{path}, {name}") if name in edit else math.nan
        elif change in ("exclude", "include"):
            pulse["excluded"] = change == "exclude"
            pulse["note"] = text_of(edit.get("reason", ""), path) if change == "exclude" else ""
