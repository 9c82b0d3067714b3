"""Contact pressure against overclosure h, and contact damping (seed 004)."""

from mpmath import mp, mpf

from .core import branch, formula, noteworthy


@formula("interaction.pressure_linear", "h k", "p")
def pressure_linear(h, k):
    noteworthy("switch", h == 0)
    return dict(p=k * h if branch(h > 0) else mpf(0))


@formula("interaction.pressure_exponential", "h c0 p0", "p")
def pressure_exponential(h, c0, p0):
    """p0/(e - 1) s (e^s - 1) with s = h/c0 + 1: nothing beyond the clearance c0, and p0 at h = 0."""
    s = h / c0 + 1
    noteworthy("switch", s == 0)
    if not branch(s > 0):
        return dict(p=mpf(0))
    return dict(p=p0 / (mp.e - 1) * s * (mp.exp(s) - 1))


@formula("interaction.damping", "h v mu0 c0 eta", "p")
def damping(h, v, mu0, c0, eta):
    """mu0 v up to the clearance eta c0, falling linearly to nothing at c0."""
    clearance = -h
    noteworthy("switch", clearance in (eta * c0, c0))
    zone = branch("full" if clearance <= eta * c0 else "falling" if clearance < c0 else "none")
    if zone == "full":
        return dict(p=mu0 * v)
    if zone == "falling":
        return dict(p=mu0 * (c0 - clearance) / (c0 - eta * c0) * v)
    return dict(p=mpf(0))
