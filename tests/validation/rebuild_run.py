#!/usr/bin/env python3
"""An independent model of a run of rift, rebuilt from its archive alone and compared row by row.

It shares nothing with rift but the file run.vtkhdf: beams are the textbook's 12 x 12 Euler-Bernoulli matrices, the
pre-stress is a direct sparse solution, time goes by velocity Verlet (eqs. 1-2 of the paper), beams soften by eqs. 9-11.
For linear kinematics, a constant velocity, one tip, a static pre-stress and no damping.
usage: rebuild_run.py RUN.vtkhdf [LIMIT]
prints the largest difference of each energy over the initial one, and ends with 1 where one is above LIMIT (1e-8)
"""
import json
import sys

import h5py
import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu


def text(node):
    return node[()].decode()


def beam_matrices(lattice):
    """[B, 12, 12] stiffnesses in the axes of space: motions (u, theta) of the first end, then of the second."""
    length, axis = lattice["length_m"][:], lattice["axis"][:]
    ea = lattice["axial_n_m"][:]  # E S / l
    ei = lattice["bending_n_m"][:] / 2.0  # E I / l
    gj = lattice["twist_n_m"][:]  # G J / l
    k = np.zeros((len(length), 12, 12))  # in the beam's axes: x along it
    k[:, 0, 0], k[:, 0, 6], k[:, 3, 3], k[:, 3, 9] = ea, -ea, gj, -gj
    for u, r, sign in ((1, 5, 1.0), (2, 4, -1.0)):  # bending in x-y and in x-z
        k[:, u, u], k[:, u, u + 6] = 12 * ei / length**2, -12 * ei / length**2
        k[:, u, r] = k[:, u, r + 6] = sign * 6 * ei / length
        k[:, r, u + 6] = k[:, u + 6, r + 6] = -sign * 6 * ei / length
        k[:, r, r], k[:, r, r + 6] = 4 * ei, 2 * ei
    for a in (0, 3, 1, 2, 4, 5):
        k[:, a + 6, a + 6] = k[:, a, a]
    k = np.triu(k) + np.triu(k, 1).transpose(0, 2, 1)
    helper = np.where(np.abs(axis[:, :1]) < 0.9, [[1.0, 0, 0]], [[0, 1.0, 0]])
    second = np.cross(axis, helper)
    second /= np.linalg.norm(second, axis=1, keepdims=True)
    frame = np.stack([axis, second, np.cross(axis, second)], axis=1)  # rows: the beam's axes
    turn = np.zeros_like(k)
    for block in range(4):
        turn[:, 3 * block : 3 * block + 3, 3 * block : 3 * block + 3] = frame
    return turn.transpose(0, 2, 1) @ k @ turn


def places(ends):
    """[B, 12] degrees of freedom of each beam."""
    one = np.arange(6)
    return np.concatenate([6 * ends[:, :1] + one, 6 * ends[:, 1:] + one], axis=1)


def assembled(matrices, at, size):
    rows = np.repeat(at, 12, axis=1).ravel()
    columns = np.tile(at, (1, 12)).ravel()
    return csr_matrix((matrices.ravel(), (rows, columns)), shape=(size, size))


class Run:
    """What the archive says of the run."""

    def __init__(self, path):
        with h5py.File(path) as file:
            lattice = file["scene/lattice"]
            header, summary = json.loads(text(file["scene/header"])), json.loads(text(file["scene/summary"]))
            scenario = summary["scenarios"][0]
            assert scenario["kinematics"] == "linear" and scenario["damping_region"] == "none"
            assert scenario["crack_course"] == "constant" and scenario["tips"] == 1 and scenario["beta"] == 1
            self.ends = lattice["ends"][:].astype(int)
            self.grip = lattice["grip"][:]
            self.mass = np.repeat(np.stack([lattice["mass_kg"][:], lattice["inertia_kg_m2"][:]], 1), 3, 1).ravel()
            self.matrices = beam_matrices(lattice)
            self.crossing = lattice["crossing"][:].astype(int)
            self.position = lattice["crossing_position_m"][:]
            self.displacement = header["displacement_m"]
            self.dt = scenario["dt_s"]
            self.speed = scenario["crack_velocity_over_cr"] * scenario["rayleigh_speed_m_s"]
            progressive = scenario["technique"] == "progressive"
            self.zone = scenario["damage_zone_ratio"] * scenario["mean_radius_m"] if progressive else 0.0
            self.exponent = scenario["relaxation"] if progressive else 1.0
            series = file["series"]
            self.series = {name: series[name][:] for name in series}
        tip = self.series["tip_m"] - self.speed * self.series["step"] * self.dt
        self.start = tip[0] + self.zone  # the tip begins a zone before it
        assert np.ptp(tip) < 1e-12

    def left(self, tip):
        """Y1/Y2 of the beams that the crack crosses (eqs. 9-11); 0 behind the tip."""
        ahead = self.position - tip
        if self.zone == 0.0:
            return (ahead > 0.0).astype(float)
        return np.clip(ahead / self.zone, 0.0, 1.0) ** self.exponent


def rebuild(run):
    """The energies [J] at the steps of the run's series, by name."""
    size = run.mass.size
    at = places(run.ends)
    crossed = np.zeros(len(run.ends), bool)
    crossed[run.crossing] = True
    whole = assembled(run.matrices[~crossed], at[~crossed], size)
    soft, soft_at = run.matrices[run.crossing], at[run.crossing]
    held = np.repeat(run.grip != 0, 6)
    free = ~held
    factor = (run.position > run.start).astype(float) if run.start > 0.0 else np.ones(len(run.position))
    u = np.zeros(size)
    u[6 * np.flatnonzero(run.grip == 2) + 1] = run.displacement
    stiffness = (whole + assembled(factor[:, None, None] * soft, soft_at, size)).tocsc()
    inner = stiffness[free][:, free]
    solver = splu(inner)
    load = -(stiffness[free][:, held] @ u[held])
    u[free] = solver.solve(load)
    u[free] += solver.solve(load - inner @ u[free])
    per_mass = np.where(free, 1.0 / run.mass, 0.0)

    def forces():
        pull = factor[:, None] * np.einsum("bij,bj->bi", soft, u[soft_at])
        return -(whole @ u + np.bincount(soft_at.ravel(), pull.ravel(), size))

    velocity, force, fracture = np.zeros(size), forces(), 0.0
    turning = np.arange(size) % 6 > 2
    rows = {name: [] for name in ("elastic", "kinetic_translation", "kinetic_rotation", "step_correction", "fracture")}
    steps = run.series["step"].astype(int)
    for step in range(steps[-1] + 1):
        for _ in range(np.count_nonzero(steps == step)):
            kinetic = 0.5 * run.mass * velocity**2 * free
            rows["elastic"].append(-0.5 * u @ force)
            rows["kinetic_translation"].append(kinetic[~turning].sum())
            rows["kinetic_rotation"].append(kinetic[turning].sum())
            rows["step_correction"].append(run.dt**2 / 8.0 * (force**2 * per_mass).sum())
            rows["fracture"].append(fracture)
        half = velocity + 0.5 * run.dt * force * per_mass
        before = u[soft_at]
        u = u + run.dt * half
        after = np.minimum(factor, run.left(run.start - run.zone + run.speed * (step + 1) * run.dt))
        lost = np.flatnonzero(after != factor)
        fracture += 0.5 * np.einsum(
            "b,bi,bij,bj->", factor[lost] - after[lost], before[lost], soft[lost], u[soft_at[lost]], optimize=True)
        factor = after
        force = forces()
        velocity = half + 0.5 * run.dt * force * per_mass
    return {name: np.array(values) for name, values in rows.items()}


def main():
    limit = float(sys.argv[2]) if len(sys.argv) > 2 else 1e-8
    run = Run(sys.argv[1])
    energies = rebuild(run)
    initial = run.series["energy_elastic_j"][0]
    worst = 0.0
    for name, values in energies.items():
        difference = np.abs(values - run.series[f"energy_{name}_j"]).max() / initial
        worst = max(worst, difference)
        print(f"{name:20} differs by at most {difference:.1e} of the initial energy in {len(values)} rows")
    print(f"largest difference {worst:.1e}, limit {limit:.0e}")
    return 0 if worst <= limit else 1


if __name__ == "__main__":
    sys.exit(main())
