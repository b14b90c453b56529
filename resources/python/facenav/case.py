"""Case: a folder with a patient's T1, model, targets and sessions."""

from dataclasses import dataclass
from pathlib import Path

import nibabel
import numpy as np

from .errors import FaceNavError
from .files import member, number_of, numbers_of, read_json, text_of
from .session import Session
from .surfaces import read_surface
from .targets import read_targets, write_targets
from .transforms import Transform

_SCHEMA = 1


@dataclass
class Landmark:
    """A place of the head (nasion, inion, tragus-left, tragus-right) in Mri, with its standard error."""

    name: str
    mm: np.ndarray
    sd_mm: float
    source: str  # skin, atlas or hand


class Case:
    """A case's folder. Its files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        path = self.folder / "case.json"
        if not path.is_file():
            raise FaceNavError(folder, "is no case: it holds no case.json")
        self.record = read_json(path)
        if member(self.record, "schema_version", path) != _SCHEMA:
            raise FaceNavError(path, f"schema version {self.record['schema_version']!r} is not {_SCHEMA}")

    @property
    def case_id(self):
        return text_of(member(self.record, "case_id", self.folder / "case.json"), self.folder / "case.json")

    @property
    def findings(self):
        return list(self.record.get("findings", []))

    # The scan

    @property
    def t1_path(self):
        """Path of the navigation T1. Throws for a case without an MRI (a measured face)."""
        path = self.folder / "mri.nii.gz"
        if not path.is_file():
            raise FaceNavError(self.folder, "the case has no MRI")
        return path

    def t1(self):
        """The T1 as a nibabel image; its affine leads to Mri."""
        return self._image("mri.nii.gz")

    def head_mask(self):
        """The head as an array of bool on the T1's grid."""
        return self._mask("head_mask.nii.gz")

    def brain_mask(self):
        """The brain mask in force; None in a case without a brain."""
        return self._mask("brain_mask.nii.gz") if (self.folder / "brain_mask.nii.gz").exists() else None

    def write_mask(self, mask, path):
        """Writes a mask on the T1's grid as NIfTI, for `facenav brain CASE --import`: a case's own masks change by that
        verb alone, since its surfaces are made from them."""
        t1 = self.t1()
        mask = np.asarray(mask)
        if mask.shape != t1.shape[:3]:
            raise FaceNavError("mask", f"has the shape {mask.shape}, the T1 has {t1.shape[:3]}")
        if not np.isin(mask, (0, 1)).all():
            raise FaceNavError("mask", "holds values other than 0 and 1")
        image = nibabel.Nifti1Image(mask.astype(np.uint8), t1.affine)
        image.set_sform(t1.affine, 1)
        image.set_qform(t1.affine, 1)
        try:
            nibabel.save(image, str(path))
        except (OSError, nibabel.filebasedimages.ImageFileError) as fault:
            raise FaceNavError(path, f"cannot be written ({fault})") from fault

    def to_mri(self, ijk):
        """Voxel indices (centres; 3, or n x 3) in Mri, mm."""
        return nibabel.affines.apply_affine(self.t1().affine, ijk)

    def to_voxel(self, mri_mm):
        """Places in Mri as continuous voxel indices."""
        return nibabel.affines.apply_affine(np.linalg.inv(self.t1().affine), mri_mm)

    # Surfaces

    def scalp(self):
        """The skin, outward normals; `doubt_mm` in its point data."""
        return read_surface(self.folder / "scalp.vtp")

    def brain(self):
        """The phi-theta model of the brain; None in a case without one."""
        return self._surface("brain.vtp")

    def cortex(self):
        """The cortex with its folds; None in older cases."""
        return self._surface("cortex.vtp")

    # Plan

    def targets(self):
        return read_targets(self.folder / "targets.json")

    def target(self, name):
        targets = self.targets()
        for target in targets:
            if target.name == name:
                return target
        known = ", ".join(f"'{target.name}'" for target in targets) or "none"
        raise FaceNavError(self.folder, f"there is no target '{name}'; there are: {known}")

    def write_targets(self, targets):
        """Replaces targets.json, whole or not at all. No other program may have the plan open."""
        write_targets(targets, self.folder / "targets.json")

    def landmarks(self):
        """Landmarks by name; empty if there are none."""
        path = self.folder / "landmarks.json"
        if not path.exists():
            return {}
        found = {}
        for one in member(read_json(path), "landmarks", path):
            name = text_of(member(one, "name", path), path)
            found[name] = Landmark(name, np.array(numbers_of(member(one, "mm", path), 3, f"{path}, {name}")),
                                   number_of(one.get("sd_mm", 0), f"{path}, {name}"),
                                   text_of(one.get("source", ""), f"{path}, {name}"))
        return found

    # Treatment

    def alignment(self):
        """camera_T_mri of the last alignment; None without one. Its errors: alignment_record()."""
        record = self.alignment_record()
        if not record:
            return None
        path = self.folder / "alignment.json"
        return Transform("camera_T_mri", numbers_of(member(record, "camera_T_mri", path), 16, f"{path}, camera_T_mri"))

    def alignment_record(self):
        """alignment.json as a dict; empty without an alignment."""
        path = self.folder / "alignment.json"
        return read_json(path) if path.exists() else {}

    def sessions(self):
        """Sessions, the oldest first."""
        folder = self.folder / "sessions"
        if not folder.is_dir():
            return []
        return [Session(path) for path in sorted(folder.iterdir()) if path.is_dir() and not path.name.startswith(".")]

    def session(self, name=""):
        """The session whose name begins so; the newest by default."""
        fitting = [session for session in self.sessions() if session.name.startswith(name)]
        if not fitting:
            raise FaceNavError(self.folder, f"there is no session '{name}'" if name else "there is no session")
        if name and len(fitting) > 1 and all(session.name != name for session in fitting):
            raise FaceNavError(self.folder, f"{len(fitting)} sessions begin with '{name}'")
        return next((session for session in fitting if session.name == name), fitting[-1])

    def _image(self, name):
        path = self.folder / name if name != "mri.nii.gz" else self.t1_path
        try:
            image = nibabel.load(str(path))
            image.get_fdata(dtype=np.float32, caching="unchanged")
            return image
        except (OSError, EOFError, ValueError, nibabel.filebasedimages.ImageFileError) as fault:
            raise FaceNavError(path, f"cannot be read ({fault})") from fault

    def _mask(self, name):
        return np.asarray(self._image(name).dataobj) != 0

    def _surface(self, name):
        path = self.folder / name
        return read_surface(path) if path.exists() else None

    def __repr__(self):
        return f"Case({str(self.folder)!r})"
