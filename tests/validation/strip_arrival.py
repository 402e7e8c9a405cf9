#!/usr/bin/env python3
"""What arrives at the tip of a crack that runs into a clamped strip from its free end, at once with a constant velocity.

Finite differences of plane elasticity on a staggered grid (velocity and stress, Virieux 1986), upper half of the strip,
which shares nothing with rift. Behind the tip the face is free, over a zone of H/40 ahead of it the traction falls
linearly, beyond it the line is held. The energy released is the work of that traction.

usage: strip_arrival.py VELOCITY [CELLS]   velocity over c_R; cells over half the height, default 120 (some minutes)
Prints lines "v_over_cr,from,to,g_over_gi0": stretches of the advance, over the height. All in units of H, E, rho.
"""
import sys

import numpy as np

POISSON, LENGTH, END = 0.28, 5.0, 3.2  # nu; plate and last position over H


def rayleigh_over_shear(nu):
    """Root of D(v) in (0, c_s) by bisection, plane stress."""
    a2 = (1 - nu) / 2
    low, high = 0.5, 0.999999
    for _ in range(60):
        v = 0.5 * (low + high)
        d = 4 * np.sqrt(1 - a2 * v * v) * np.sqrt(1 - v * v) - (2 - v * v) ** 2
        low, high = (v, high) if d > 0 else (low, v)
    return low


class Strip:
    """Stretched by a unit strain; vx, vy, sxx, syy, sxy on their staggered places, the crack's line at row 0 of vy."""

    def __init__(self, cells):
        self.h = 0.5 / cells
        nx = round(LENGTH / self.h)
        self.c11, self.mu = 1 / (1 - POISSON**2), 1 / (2 * (1 + POISSON))
        self.c12 = POISSON * self.c11
        self.dt = 0.6 * self.h / np.sqrt(self.c11)
        self.vx, self.vy = np.zeros((nx + 1, cells)), np.zeros((nx, cells + 1))
        self.sxx, self.syy = np.full((nx, cells), self.c12), np.full((nx, cells), self.c11)
        self.sxy = np.zeros((nx + 1, cells + 1))
        self.x = (np.arange(nx) + 0.5) * self.h

    def step(self, held, traction, keep=1.0):
        h, dt = self.h, self.dt
        vx, vy, sxx, syy, sxy = self.vx, self.vy, self.sxx, self.syy, self.sxy
        vx[1:-1] += dt * (np.diff(sxx, axis=0) + np.diff(sxy, axis=1)[1:-1]) / h
        vx[0] += dt * sxx[0] / (h / 2)
        vx[-1] -= dt * sxx[-1] / (h / 2)
        vy[:, 1:-1] += dt * (np.diff(syy, axis=1) + np.diff(sxy, axis=0)[:, 1:-1]) / h
        vy[:, 0] = np.where(held, 0.0, vy[:, 0] + dt * (syy[:, 0] - traction) / (h / 2))
        if keep != 1.0:
            vx *= keep
            vy *= keep
        ex, ey = np.diff(vx, axis=0) / h, np.diff(vy, axis=1) / h
        sxx += dt * (self.c11 * ex + self.c12 * ey)
        syy += dt * (self.c12 * ex + self.c11 * ey)
        sxy[1:-1, 1:-1] += dt * self.mu * (np.diff(vx, axis=1)[1:-1] + np.diff(vy, axis=0)[:, 1:-1]) / h
        sxy[1:-1, -1] -= dt * self.mu * 2 * vx[1:-1, -1] / h  # the grip holds it


def released(v_over_cr, cells):
    """Tip positions and the energy released up to them, over G_I0."""
    strip = Strip(cells)
    all_held, nothing = np.ones(len(strip.x), bool), np.zeros(len(strip.x))
    c_d = np.sqrt(strip.c11)
    for _ in range(int(14 / c_d / strip.dt)):  # to rest, the ends free
        strip.step(all_held, nothing, 1 - 2.5 * strip.dt * c_d)
    strip.vx[:] = 0
    strip.vy[:] = 0
    v = v_over_cr * rayleigh_over_shear(POISSON) * np.sqrt(strip.mu)
    zone, first, energy, rows = 1 / 40, np.full(len(strip.x), np.nan), 0.0, []
    for k in range(int((END + 0.05 + zone) / v / strip.dt)):
        tip = v * k * strip.dt - zone
        part = np.clip((tip + zone - strip.x) / zone, 0, 1)
        reached = (part > 0) & np.isnan(first)
        first[reached] = strip.syy[reached, 0]
        held = part <= 0
        traction = np.where(held, 0.0, np.nan_to_num(first) * (1 - part))
        before = strip.vy[:, 0].copy()
        strip.step(held, traction)
        energy += np.sum(traction * (strip.vy[:, 0] + before)) * strip.h * strip.dt  # both halves
        rows.append((tip, energy / (0.5 * strip.c11)))
    return np.array(rows).T


if __name__ == "__main__":
    velocity = float(sys.argv[1])
    tip, energy = released(velocity, int(sys.argv[2]) if len(sys.argv) > 2 else 120)
    for k in range(10, 32):
        ends = np.array([k, k + 1]) / 10
        print(f"{velocity:g},{ends[0]:.1f},{ends[1]:.1f},{np.diff(np.interp(ends, tip, energy))[0] / 0.1:.3f}")
