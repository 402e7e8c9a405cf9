#!/usr/bin/env python3
"""Measures rift view against a terminal that reads at once and answers at once, for the table of docs/view.md.

usage: figures.py RIFT RUN [--line BYTES_PER_S] [--memory]
       figures.py RIFT PRESET --pairs N [--threads N]
Prints pictures and bytes a second while it plays, the delay from a key to its picture, and the time to the first one; or
how fast a run marches with the picture in its panel, against the same run with cells, in pairs one after the other.
"""
import argparse
import fcntl
import json
import os
import pty
import select
import shutil
import statistics
import struct
import tempfile
import termios
import time


class Terminal:
    """Counts pictures by the question that follows each."""

    def __init__(self, words, kind, columns, rows, cell, environment, line=0.0):
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            for name in ("TMUX", "STY", "COLORTERM"):
                os.environ.pop(name, None)
            os.environ.update({"TERM": "xterm-256color", "LC_ALL": "C.UTF-8", **environment})
            os.execv(words[0], words)
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        self.start, self.bytes, self.pictures, self.line = time.time(), 0, [], line
        self.begun = b""  # of a question whose rest has not been read yet
        kitty = b"\x1b_Gi=31;OK\x1b\\" if kind == "kitty" else b""
        attributes = b"\x1b[?62;4c" if kind == "sixel" else b"\x1b[?62;c"
        self.answers = [(b"\x1b_Gi=31,", kitty), (b"\x1b[16t", b"\x1b[6;%d;%dt" % (cell[1], cell[0])),
                        (b"\x1b[c", attributes), (b"\x1b[5n", b"\x1b[0n")]

    def now(self):
        return time.time() - self.start

    def read_for(self, seconds):
        """Returns whether the program is still there."""
        until = self.now() + seconds
        while self.now() < until:
            if not select.select([self.master], [], [], 0.005)[0]:
                continue
            try:
                piece = os.read(self.master, 4096 if self.line else 65536)
            except OSError:  # it has ended
                return False
            if self.line:
                time.sleep(len(piece) / self.line)
            self.bytes += len(piece)
            piece = self.begun + piece
            self.begun = b""
            for question, answer in self.answers:
                for _ in range(piece.count(question)):
                    if question == b"\x1b[5n":
                        self.pictures.append((self.now(), self.bytes))
                    os.write(self.master, answer)
                cut_off = [n for n in range(1, len(question)) if piece.endswith(question[:n])]
                if cut_off and cut_off[-1] > len(self.begun):
                    self.begun = piece[-cut_off[-1]:]
        return True

    def type(self, keys):
        os.write(self.master, keys)
        return self.now()

    def rate(self, start, end):
        shown = [p for p in self.pictures if start <= p[0] <= end]
        if len(shown) < 2:
            return 0.0, 0.0
        seconds = shown[-1][0] - shown[0][0]
        return (len(shown) - 1) / seconds, (shown[-1][1] - shown[0][1]) / seconds

    def memory_kb(self):
        children = open(f"/proc/{self.pid}/task/{self.pid}/children").read().split()
        sizes = []
        for process in [str(self.pid)] + children:
            for row in open(f"/proc/{process}/status"):
                if row.startswith("VmRSS"):
                    sizes.append(int(row.split()[1]))
        return sizes

    def close(self):
        os.write(self.master, b"q")
        self.read_for(0.5)
        os.close(self.master)
        os.waitpid(self.pid, 0)


def march(rift, preset, threads, with_picture, folder):
    """Seconds of the crack's march, and pictures shown."""
    words = [rift, "run", preset, "--out", folder, "--threads", str(threads)]
    terminal = Terminal(words, "kitty", 120, 40, (8, 16), {})
    terminal.read_for(0.5)
    if with_picture:
        terminal.type(b"p")
    while terminal.read_for(1):
        pass
    os.close(terminal.master)
    os.waitpid(terminal.pid, 0)
    scenario = json.load(open(folder + "/summary.json"))["scenarios"][0]
    shutil.rmtree(folder)
    return scenario["wall_pass_s"], len(terminal.pictures)


def march_in_pairs(options):
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for k in range(options.pairs):
            order = (False, True) if k % 2 == 0 else (True, False)  # each is first as often as the other
            took = {shown: march(options.rift, options.run, options.threads, shown, folder + "/run") for shown in order}
            ratios.append(took[False][0] / took[True][0])
            print(f"cells {took[False][0]:.2f} s, picture {took[True][0]:.2f} s with {took[True][1]} pictures: "
                  f"{ratios[-1]:.3f} x as fast", flush=True)
    print(f"median {statistics.median(ratios):.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rift")
    parser.add_argument("run")
    parser.add_argument("--line", type=float, default=0.0, help="bytes a second")
    parser.add_argument("--memory", action="store_true", help="over 2,000 pictures")
    parser.add_argument("--pairs", type=int, default=0, help="of runs")
    parser.add_argument("--threads", type=int, default=1, help="of these runs")
    options = parser.parse_args()
    if options.pairs:
        return march_in_pairs(options)
    cases = [("sixel", 96, 31, (10, 20), {}), ("kitty", 96, 31, (10, 20), {}),
             ("symbols", 120, 44, (8, 16), {"COLORTERM": "truecolor"})]
    for kind, columns, rows, cell, environment in cases:
        terminal = Terminal([options.rift, "view", options.run], kind, columns, rows, cell, environment, options.line)
        terminal.read_for(8 if options.line else 3)
        first, size = terminal.pictures[0]
        terminal.type(b">>>>> ")
        start = terminal.now()
        terminal.read_for(8 if options.line else 2.5)
        pictures, rate = terminal.rate(start, terminal.now())
        terminal.type(b" ")
        terminal.read_for(5 if options.line else 1)
        delays = []
        for key in (b"+", b"d", b"D", b"-", b"+", b"d", b"A", b"-"):
            pressed = terminal.type(key)
            terminal.read_for(6 if options.line else 1)
            delays += [t - pressed for t, _ in terminal.pictures if t > pressed][:1]
        print(f"{kind}: first picture {first:.2f} s, {pictures:.1f} pictures/s, {rate / 1e3:.0f} kB/s, key to picture "
              f"{1e3 * sum(delays) / len(delays):.0f} ms, at most {1e3 * max(delays):.0f} ms", flush=True)
        if options.memory and kind == "sixel":
            while len(terminal.pictures) < 2000:
                terminal.type(b"> " if len(terminal.pictures) % 2 else b" ")
                terminal.read_for(2)
                if len(terminal.pictures) % 200 < 40:
                    print(len(terminal.pictures), terminal.memory_kb(), flush=True)
        terminal.close()


if __name__ == "__main__":
    main()
