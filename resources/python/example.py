#!/usr/bin/env python3
"""A look at a case: python3 example.py CASE. With --add NAME it plans a target 10 mm in front of the first one."""

import sys

import numpy as np

import facenav

case = facenav.Case(sys.argv[1])
print("case", case.case_id, "T1", case.t1().shape)

# Surfaces are points and triangles in Mri, mm.
scalp = case.scalp()
print("scalp:", len(scalp.points_mm), "points,", len(scalp.triangles), "triangles")

# Targets are wanted poses of the coil.
for target in case.targets():
    depth_mm = np.linalg.norm(target.scalp_point_mm - target.cortex_point_mm)
    print(f"target {target.name}: cortex at {target.cortex_point_mm.round(1)}, {depth_mm:.1f} mm below the skin")

# Sessions hold tables: one row a pulse, one row a frame and object.
for session in case.sessions():
    pulses = session.pulses()
    kept = pulses[~pulses["excluded"]]
    print(f"session {session.name}: {len(pulses)} pulses, {len(kept)} kept,"
          f" median distance {np.nanmedian(kept['distance_mm']) if len(kept) else np.nan:.2f} mm")
    # Transforms know their frames: a chain that does not fit is refused.
    poses = session.poses()
    tracked = poses[poses["status"] == "tracked"]
    heads = {row["frame"]: row for row in tracked if row["object"] == "head" and row["of_frame"] == "mri"}
    for coil in tracked[tracked["object"] == "coil"]:
        if coil["frame"] in heads:
            mri_T_coil = session.transform(heads[coil["frame"]]).inverse() @ session.transform(coil)
            print("  first pose of the coil in the MRI:", mri_T_coil)
            break

if "--add" in sys.argv:
    first = case.targets()[0]
    scalp_point = first.scalp_point_mm + [0, 10, 0]
    place = scalp.points_mm[np.linalg.norm(scalp.points_mm - scalp_point, axis=1).argmin()]
    cortex_point = first.cortex_point_mm + [0, 10, 0]
    pose = facenav.planned_pose(place, cortex_point, handle_mm=-first.mri_T_target[:3, 1])
    new = facenav.Target(sys.argv[sys.argv.index("--add") + 1], pose, cortex_point, place, note="planned in Python")
    case.write_targets(case.targets() + [new])
