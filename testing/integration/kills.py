#!/usr/bin/env python3
"""Kills `facenav track --pulses` (kill -9) at random moments, goes on with the session each time, and counts.

Pulses come over UDP at 10 Hz; the intensity of each says which one it is. After each kill the pulses in the
session's file are compared with those that the program had told of (told means: on the disk), and with
those that were sent while it listened, but for the last 0.7 s. Prints one line a kill and a summary; exit status 1
when a pulse was lost or doubled, or the session was not back in time.

  testing/integration/kills.py build/release/bin/facenav CASE RECORDING [--kills 20] [--seed 1]

CASE: prepared and planned, aligned with RECORDING (`facenav demo -o DIR` makes both). A copy of it is used.
"""
import argparse
import json
import os
import pathlib
import random
import select
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

STEP_S = 0.1
FIRST_PCT, TAG_PCT = 20.0, 0.001
ON_THE_WAY_S = 0.7  # a pulse is kept when the frame after it has come, at the latest after 0.5 s


class Track:
    """One run of the program; hears what it tells, line by line."""

    def __init__(self, facenav, case, recording, port, folder, goes_on):
        words = [facenav, "track", recording, "--case", case, "--pulses", f"udp:127.0.0.1:{port}", "--commands",
                 "--passes", "0", "-q", "--by", "kills.py", "--override", "a test", "-o", folder / "poses.csv"]
        self.begun_s = time.monotonic()
        self.process = subprocess.Popen([str(w) for w in words + (["--continue"] if goes_on else [])],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.text = b""
        self.told, self.back_s, self.checked_s, self.name, self.counted = [], None, None, None, None

    def hear(self, seconds):
        """Takes what comes in this time; False at the end of the output."""
        end_s = time.monotonic() + seconds
        while True:
            left_s = end_s - time.monotonic()
            if not select.select([self.process.stdout], [], [], max(0.0, left_s))[0]:
                return True
            chunk = os.read(self.process.stdout.fileno(), 65536)
            if not chunk:
                return False
            *lines, self.text = (self.text + chunk).split(b"\n")
            for line in lines:
                self.take(json.loads(line))

    def take(self, line):
        now_s = time.monotonic() - self.begun_s
        if "session" in line:
            self.name, self.back_s, self.counted = line["session"], now_s, line["pulses"]
        elif line.get("check"):
            self.checked_s = self.checked_s or now_s
        elif "pulse" in line:
            self.told.append(tag_of(line))

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        while self.hear(5.0):
            pass
        self.process.wait()


def tag_of(pulse):
    return round((pulse.get("intensity_pct", 0) - FIRST_PCT) / TAG_PCT)


def kept_in(session):
    """Tags of the pulses in the file; a line that the kill tore is none."""
    tags, numbers = [], []
    for line in (session / "pulses.jsonl").read_text().split("\n") if (session / "pulses.jsonl").exists() else []:
        try:
            pulse = json.loads(line)
        except ValueError:
            continue
        if "pulse" in pulse:
            tags.append(tag_of(pulse))
            numbers.append(pulse["pulse"])
    return tags, numbers


def send_until(track, sender, port, sent, end_s):
    while time.monotonic() < end_s:
        sent.append(time.monotonic())
        pulse = {"pulse": True, "intensity_pct": round(FIRST_PCT + TAG_PCT * len(sent), 3)}
        sender.sendto(json.dumps(pulse).encode(), ("127.0.0.1", port))
        if not track.hear(max(0.0, min(STEP_S, end_s - time.monotonic()))):
            return


def words_of(seconds):
    return "     -" if seconds is None else f"{seconds:6.1f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("facenav")
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("recording", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--latest", type=float, default=12.0, help="of a kill after the start, s")
    parser.add_argument("--within", type=float, default=10.0, help="the session is back, s")
    given = parser.parse_args()
    draw = random.Random(given.seed)
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    sent, told, back_s, checked_s, session = [], [], [], [], None
    lost, doubled, heard = set(), set(), set()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        case = folder / "case"
        shutil.copytree(given.case, case)
        shutil.rmtree(case / "sessions", ignore_errors=True)
        print("kill  after s  session back s  checked s   told   kept   lost  doubled")
        kill = 0
        while kill <= given.kills:
            track = Track(given.facenav, case, given.recording, port, folder, session is not None)
            is_last = kill == given.kills
            if session is None:  # the first session must have begun
                while track.back_s is None and track.hear(0.1):
                    pass
            end_s = time.monotonic() + (given.latest if is_last else draw.uniform(0.0, given.latest))
            send_until(track, sender, port, sent, end_s)
            killed_s = time.monotonic()
            at_s = killed_s - track.begun_s
            track.kill()
            if track.name:
                session = case / "sessions" / track.name
            elif session is None:
                sys.exit("no session began")
            told += track.told
            tags, numbers = kept_in(session)
            lost |= set(told) - set(tags)
            if track.back_s is not None:
                listened_s = track.begun_s + track.back_s
                heard |= {i + 1 for i, at in enumerate(sent) if listened_s < at < killed_s - ON_THE_WAY_S}
            lost |= heard - set(tags)
            doubled |= {tag for tag in tags if tags.count(tag) > 1} | {n for n in numbers if numbers.count(n) > 1}
            if kill > 0 and track.back_s is not None:
                back_s.append(track.back_s)
            if kill > 0 and track.checked_s is not None:
                checked_s.append(track.checked_s)
            print(f"{kill + 1:4} {at_s:8.1f} {words_of(track.back_s):>15} {words_of(track.checked_s):>10} "
                  f"{len(told):6} {len(tags):6} {len(lost):6} {len(doubled):8}", flush=True)
            kill += 1
        count = len(list((case / "sessions").iterdir()))
    print(f"{kill} kills, {len(heard)} pulses sent while it listened, {len(told)} told, {len(tags)} kept in {count} session(s): "
          f"{len(lost)} lost, {len(doubled)} doubled")
    if back_s:
        print(f"session back after {sorted(back_s)[len(back_s) // 2]:.1f} s (median), {max(back_s):.1f} s (most), "
              f"of {len(back_s)} returns")
    if checked_s:
        print(f"registration checked after {sorted(checked_s)[len(checked_s) // 2]:.1f} s (median), "
              f"{max(checked_s):.1f} s (most), of {len(checked_s)}")
    sys.exit(1 if lost or doubled or count != 1 or max(back_s, default=0) > given.within else 0)


if __name__ == "__main__":
    main()
