# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The heart valve with rigid leaflets (cases/heart_valve/rigid.geo): where both programs are read, and what follows from it.

Lengths in m. A section is a list of places (x, y); upward ones begin on the axis or on the leaflet and end on the wall.
"""
import math

HALF_WIDTH, CHAMBER_RADIUS, LEAFLET_LENGTH, LEAFLET_THICKNESS, TIP_GAP = 0.0125, 0.0215, 0.016, 0.001, 0.004
DENSITY, VISCOSITY = 1056.0, 3.5e-3
SPEEDS = (0.2, 0.9)  # of the inflow on the axis [m/s]

CORNER = math.sqrt(CHAMBER_RADIUS**2 - HALF_WIDTH**2)
SINE = (HALF_WIDTH - TIP_GAP / 2) / LEAFLET_LENGTH
COSINE = math.sqrt(1 - SINE**2)
TIP = -CORNER + LEAFLET_LENGTH * COSINE
THROAT = TIP - LEAFLET_THICKNESS / 2 * COSINE  # under the middle of the round tip: the narrowest place
THROAT_HALF = TIP_GAP / 2 - LEAFLET_THICKNESS / 2 * (1 - SINE)
MEASURED_UPSTREAM, MEASURED_DOWNSTREAM = -0.030, 0.040  # where pressures are read


def upward(x, low, high, points):
    return [(x, low + (high - low) * k / (points - 1)) for k in range(points)]


def chamber_low(x):
    """Where the chamber begins above x: the upper side of the leaflet, or the axis."""
    if x > TIP:
        return 0.0
    return HALF_WIDTH - (x + CORNER) * SINE / COSINE + LEAFLET_THICKNESS / 2 / COSINE


def chamber_columns():
    """Upward sections through the chamber and the vessel behind it, 3 mm apart: for the stream function."""
    xs = [x / 1000 for x in range(-14, 47, 3)]
    return {f"column_{k:02d}": upward(x, chamber_low(x), math.sqrt(CHAMBER_RADIUS**2 - x**2) if x < CORNER else HALF_WIDTH, 41)
            for k, x in enumerate(xs)}


def sections():
    axis = [(MEASURED_UPSTREAM + (MEASURED_DOWNSTREAM - MEASURED_UPSTREAM) * k / 140, 0.0) for k in range(141)]
    return {"inlet": upward(MEASURED_UPSTREAM, 0, HALF_WIDTH, 26),
            "throat": upward(THROAT, 0, THROAT_HALF, 37),
            "tip": upward(TIP, 0, TIP_GAP / 2, 41),
            "chamber": upward(0.0, 0, CHAMBER_RADIUS, 87),
            "axis": axis}


def integral(places, values):
    """Of values along a section, by trapezia; those that could not be read are left out."""
    known = [(s, u) for s, u in zip((y for _, y in places), values) if not math.isnan(u)]
    return sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(known, known[1:]))


def least_stream_function(columns, u):
    """Of each column x, the place y and the value of the least stream function, which is 0 on the wall: below 0 is what flows
    back above y, and below y as much flows forward again."""
    best = []
    for name, places in columns.items():
        known = [(y, w) for (_, y), w in zip(places, u[name]) if not math.isnan(w)]
        psi, least, where = 0.0, 0.0, known[-1][0]
        for (low, below), (high, above) in zip(known[::-1][1:], known[::-1]):
            psi += (below + above) / 2 * (high - low)  # what flows to the right between here and the wall
            if psi < least:
                least, where = psi, low
        best.append((places[0][0], where, least))
    return best


def centre(best):
    """Centre (x, y) of the strongest vortex and the flux that turns in it [m^2/s], by a parabola through three columns."""
    k = min(range(len(best)), key=lambda n: best[n][2])
    if not 0 < k < len(best) - 1:
        return best[k][0], best[k][1], -best[k][2]
    (x0, y0, a), (x1, y1, b), (x2, y2, c) = best[k - 1:k + 2]
    shift = (a - c) / (2 * (a - 2 * b + c))
    y = y1 + (y2 - y0) / 2 * shift
    return x1 + shift * (x2 - x1), y, -(b - (a - c) * shift / 4)


def quantities(u, pressure, columns_u):
    """What is compared: `u` along each of sections(), `pressure` along its axis, `columns_u` along chamber_columns()."""
    places = sections()
    flux = integral(places["inlet"], u["inlet"])
    mean = flux / HALF_WIDTH
    best = least_stream_function(chamber_columns(), columns_u)
    x, y, turning = centre(best)
    middle = min(best, key=lambda column: abs(column[0]))  # nearest to the middle of the chamber

    def peak(name):
        return max(value for value in u[name] if not math.isnan(value))

    head = DENSITY / 2 * (flux / THROAT_HALF)**2
    return {"mean_inflow_m_s": mean, "inflow_on_axis_m_s": u["inlet"][0],
            "throat_peak_m_s": peak("throat"), "throat_axis_m_s": u["throat"][0], "tip_peak_m_s": peak("tip"),
            "throat_peak_over_mean_inflow": peak("throat") / mean, "tip_peak_over_mean_inflow": peak("tip") / mean,
            "axis_peak_m_s": peak("axis"), "chamber_axis_over_mean_inflow": u["chamber"][0] / mean,
            "pressure_drop_pa": pressure[0] - pressure[-1], "pressure_drop_over_head": (pressure[0] - pressure[-1]) / head,
            "vortex_x_mm": x * 1e3, "vortex_y_mm": y * 1e3, "vortex_flux_over_inflow": turning / flux,
            "backflow_in_chamber_over_inflow": -middle[2] / flux, "its_lower_edge_mm": middle[1] * 1e3,
            "chamber_backflow_peak_over_mean_inflow": min(value for value in u["chamber"] if not math.isnan(value)) / mean}
