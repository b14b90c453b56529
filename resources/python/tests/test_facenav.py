"""Tests of the package on a case that FaceNav made. FACENAV_CASE: a copy to work on; FACENAV_CLI: the program."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import facenav

CASE, CLI = os.environ.get("FACENAV_CASE", ""), os.environ.get("FACENAV_CLI", "")


def run(*words):
    result = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=60)
    return result


class Transforms(unittest.TestCase):
    def test_chains_fit_by_their_frames(self):
        turn = facenav.Transform("camera_T_mri", [0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1])
        coil = facenav.Transform("mri_T_coil", np.eye(4))
        self.assertEqual((turn @ coil).name, "camera_T_coil")
        np.testing.assert_allclose(turn.apply([10, 0, 0]), [1, 12, 3])
        np.testing.assert_allclose(turn.inverse().apply([[1, 12, 3]]), [[10, 0, 0]], atol=1e-12)
        with self.assertRaisesRegex(facenav.FaceNavError, "does not fit: mri is not coil"):
            turn @ coil.inverse()

    def test_quaternions_come_back_for_any_turn(self):
        from facenav.transforms import matrix_from_quaternion, quaternion_of
        random = np.random.default_rng(3)
        for q in [*random.normal(size=(50, 4)), [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0]]:
            q = np.array(q) / np.linalg.norm(q)
            back = quaternion_of(matrix_from_quaternion([1, 2, 3], q))
            self.assertGreaterEqual(back[0], 0)
            np.testing.assert_allclose(abs(back @ q), 1, atol=1e-12)

    def test_what_is_no_rigid_transform_is_refused(self):
        for matrix, words in ((np.diag([1, 1, -1, 1]), "mirrored"), (2 * np.eye(4), "last row"),
                              (np.diag([1.1, 1, 1, 1]), "no rotation"), (np.full((4, 4), np.nan), "no numbers"),
                              ([1, 2, 3], "4x4"), ("x", "16 numbers")):
            with self.assertRaisesRegex(facenav.FaceNavError, words):
                facenav.Transform("mri_T_coil", matrix)


@unittest.skipUnless(CASE, "FACENAV_CASE is not set")
class OnACase(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        shutil.copytree(CASE, self.folder / "case")
        self.case = facenav.Case(self.folder / "case")

    def tearDown(self):
        shutil.rmtree(self.folder)

    def at(self, name):
        return self.folder / name

    def write(self, name, text):
        (self.case.folder / name).write_text(text, encoding="utf-8")

    def refused(self, action, words):
        with self.assertRaisesRegex(facenav.FaceNavError, words) as caught:
            action()
        self.assertNotIn("\n", str(caught.exception))

    def test_scan_masks_and_coordinates(self):
        ijk = np.array([3.0, 20.0, 41.0])
        np.testing.assert_allclose(self.case.to_voxel(self.case.to_mri(ijk)), ijk, atol=1e-6)
        head, brain = self.case.head_mask(), self.case.brain_mask()
        self.assertEqual(head.shape, self.case.t1().shape)
        self.assertTrue((head | ~brain).all(), "the brain lies in the head")
        inside = self.case.to_mri(np.argwhere(head).mean(axis=0))
        np.testing.assert_allclose(inside, [0, 0, 0], atol=0.5)  # the ball's centre

    def test_surfaces_are_where_they_must_be(self):
        scalp = self.case.scalp()
        radius_mm = np.linalg.norm(scalp.points_mm, axis=1)
        np.testing.assert_allclose(radius_mm, 90, atol=0.5)
        corners = scalp.points_mm[scalp.triangles]
        outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self.assertTrue((np.einsum("ij,ij->i", outward, corners.mean(axis=1)) > -1e-6).all())
        self.assertLess(np.linalg.norm(self.case.brain().points_mm, axis=1).max(), 45)

    def test_targets_of_facenav_are_read_and_kept(self):
        self.assertEqual([t.name for t in self.case.targets()], ["M1 hand L", "左 DLPFC"])
        before = (self.case.folder / "targets.json").read_text(encoding="utf-8")
        self.case.write_targets(self.case.targets())
        after = (self.case.folder / "targets.json").read_text(encoding="utf-8")
        np.testing.assert_equal(len(json.loads(after)["targets"]), len(json.loads(before)["targets"]))
        for old, new in zip(json.loads(before)["targets"], json.loads(after)["targets"]):
            self.assertEqual(set(old), set(new))
            np.testing.assert_allclose(old["mri_T_target"], new["mri_T_target"], atol=1e-12)
        self.assertEqual((self.case.folder / "targets.json").stat().st_mode & 0o777, 0o600)

    def test_facenav_takes_a_target_written_here(self):
        first = self.case.target("M1 hand L")
        pose = facenav.planned_pose([0, 0, 92], [5, 0, 60], handle_mm=[0, -1, 0])
        np.testing.assert_allclose(np.linalg.det(pose[:3, :3]), 1)
        new = facenav.Target("vertex, \"Ü\"", pose, [5, 0, 60], [0, 0, 90], note="in\nPython",
                             more={"other_tool": {"a": 1}})
        self.case.write_targets([first, new])
        shown = run("plan", self.case.folder, "--json")
        self.assertEqual(shown.returncode, 0, shown.stderr)
        listed = json.loads(shown.stdout)
        names = [t["name"] for t in listed["targets"]]
        self.assertEqual(names, ["M1 hand L", "vertex, \"Ü\""])
        out = self.at("back.json")
        self.assertEqual(run("export", self.case.folder, "--as", "json", "-o", out).returncode, 0)
        back = facenav.read_targets(out)[1]
        np.testing.assert_allclose(back.mri_T_target, pose, atol=1e-9)
        np.testing.assert_allclose(back.cortex_point_mm, [5, 0, 60])

    def test_pulses_of_a_session_agree_with_the_program(self):
        session = self.case.session()
        self.assertEqual(run("pulses", self.case.folder, "--exclude", "3", "--reason", "moved").returncode, 0)
        pulses = session.pulses()
        out = self.at("pulses.csv")
        self.assertEqual(run("pulses", self.case.folder, "-o", out).returncode, 0)
        table = facenav.read_pulses_csv(out)
        for name in ("pulse", "utc", "target", "status", "reason", "excluded", "note", "coil"):
            np.testing.assert_array_equal(pulses[name], table[name], name)
        for name in ("distance_mm", "tilt_deg", "mep_uv", "mri_T_coil"):
            np.testing.assert_allclose(pulses[name], table[name], atol=2e-3, err_msg=name)
        self.assertEqual(pulses["excluded"].sum(), 1)
        self.assertTrue(np.isnan(pulses["mri_T_coil"][pulses["status"] == "lost"]).all())
        again = self.at("again.csv")
        facenav.write_pulses_csv(pulses, again)
        np.testing.assert_array_equal(facenav.read_pulses_csv(again)["note"], pulses["note"])
        checked = run("import", self.case.folder, again, "--dry-run")
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_poses_chain_to_the_pose_of_the_coil(self):
        session = self.case.session()
        poses = session.poses()
        head, coil = session.poses("head"), session.poses("coil")
        self.assertEqual(len(head) + len(coil), len(poses))
        tracked = head["status"] == "tracked"
        self.assertTrue(tracked.any() and not tracked.all())
        self.assertTrue(np.isnan(head["pose"][~tracked]).all())
        n = int(np.flatnonzero(tracked)[0])
        self.assertEqual(head["of_frame"][n], "mri")
        mri_T_coil = session.transform(head[n]).inverse() @ session.transform(coil[n])
        target = self.case.target("M1 hand L")
        distance_mm = np.linalg.norm(mri_T_coil.translation_mm - target.transform.translation_mm)
        guidance = session.guidance()
        self.assertAlmostEqual(distance_mm, guidance["distance_mm"][guidance["frame"] == head["frame"][n]][0], 2)
        out = self.at("poses.csv")
        facenav.write_poses(poses, out)
        back = facenav.read_poses(out)
        np.testing.assert_allclose(back["pose"], poses["pose"], atol=1e-6)
        guided = run("guide", self.case.folder, out, "--target", "M1 hand L", "-o", self.at("guidance.csv"))
        self.assertEqual(guided.returncode, 0, guided.stderr)

    def test_a_mask_written_here_is_taken(self):
        mask = self.case.brain_mask()
        self.case.write_mask(mask, self.at("mask.nii.gz"))
        taken = run("brain", self.case.folder, "--import", self.at("mask.nii.gz"))
        self.assertEqual(taken.returncode, 0, taken.stderr)
        np.testing.assert_array_equal(self.case.brain_mask(), mask)
        self.refused(lambda: self.case.write_mask(mask[:-1], self.at("x.nii.gz")), "has the shape")
        self.refused(lambda: self.case.write_mask(mask * 2, self.at("x.nii.gz")), "other than 0 and 1")

    def test_bad_files_give_one_clear_exception(self):
        target = json.dumps({"name": "a", "mri_T_target": np.eye(4).ravel().tolist(), "cortex_point_mm": [0, 0, 0],
                             "scalp_point_mm": [0, 0, 0]})
        for text, words in (("", "is not JSON"), ("[]", "no JSON object"), ("{}", "has no 'targets'"),
                            ('{"targets": 3}', "no list"), ('{"targets": [3]}', "a target was expected"),
                            (f'{{"targets": [{target}, {target}]}}', "two targets have the name 'a'"),
                            (f'{{"targets": [{target.replace("1.0", "NaN")}]}}', "is not JSON"),
                            (f'{{"targets": [{target.replace("1.0", "true")}]}}', "a number was expected"),
                            (f'{{"targets": [{target.replace("1.0", "1.1", 1)}]}}', "no rotation"),
                            (f'{{"targets": [{target.replace("[0, 0, 0]", "[0, 0]")}]}}', "3 numbers"),
                            (f'{{"targets": [{target.replace("[0, 0, 0]", "[0, 0, 5000]")}]}}', "near the head"),
                            ("[" * 100000, "is not JSON")):
            self.write("targets.json", text)
            self.refused(self.case.targets, words)
        session = self.case.session()
        header = "frame,t_s,object,status,tx,ty,tz,qw,qx,qy,qz,quality,reason\n"
        for text, words in (("", "no header"), ("frame,t_s\n", "no column 'object'"),
                            (header + "0,0,head,tracked,1\n", "fields"),
                            (header + "0,0,head,tracked,1,2,3,1,1,0,0,1,\n", "unit length"),
                            (header + "0,0,head,tracked,,2,3,1,0,0,0,1,\n", "in column 'tx'"),
                            (header + "0.5,0,head,lost,,,,,,,,0,no_face\n", "whole number"),
                            (header + "0,nan,head,lost,,,,,,,,0,no_face\n", "no usable number")):
            (session.folder / "poses.csv").write_text(text)
            self.refused(session.poses, words)
        for name in ("scalp.vtp", "mri.nii.gz", "case.json"):
            content = (self.case.folder / name).read_bytes()
            (self.case.folder / name).write_bytes(content[:len(content) // 2])
        self.refused(self.case.scalp, "scalp.vtp")
        self.refused(self.case.t1, "mri.nii.gz")
        self.refused(lambda: facenav.Case(self.case.folder), "case.json")
        self.refused(lambda: facenav.Case(self.folder / "absent"), "is no case")

    def test_an_unsound_target_changes_nothing(self):
        before = (self.case.folder / "targets.json").read_bytes()
        good = self.case.targets()
        for change, words in (({"name": ""}, "is empty"), ({"name": "a\nb"}, "control character"),
                              ({"name": "x" * 121}, "longer than 120"), ({"note": 3}, "text was expected"),
                              ({"mri_T_target": np.diag([1, 1, -1, 1])}, "mirrored"),
                              ({"cortex_point_mm": [np.nan, 0, 0]}, "near the head"),
                              ({"scalp_point_mm": "x"}, "3 numbers"), ({"more": {"a": {1}}}, "are no JSON")):
            bad = facenav.Target(**{**vars(good[0]), **change})
            self.refused(lambda: self.case.write_targets([good[1], bad]), words)
        self.refused(lambda: self.case.write_targets([good[0], good[0]]), "two targets")
        locked = facenav.Target(**{**vars(good[0]), "more": {"locked": True}})
        self.assertEqual((self.case.folder / "targets.json").read_bytes(), before)
        self.case.write_targets([locked, good[1]])
        self.refused(lambda: self.case.write_targets([good[1]]), "is locked")


if __name__ == "__main__":
    unittest.main()
