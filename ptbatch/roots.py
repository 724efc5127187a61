"""Root of a function between two places where its signs differ."""

from collections.abc import Callable

ROUND_OFF = 4.0 * 2.0**-52


def root(
    f: Callable[[float], float], a: float, b: float, xtol: float = 2e-12, rtol: float = ROUND_OFF
) -> float:
    """A root of f between a and b, to xtol + rtol |root|.

    Chandrupatla's method (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where
    that is safe, bisection elsewhere. Raises ValueError if the signs of f at a and b are the same.
    """
    fa, fb = float(f(a)), float(f(b))
    if fa * fb > 0.0:
        raise ValueError(f"no change of sign between {a:g} and {b:g}")
    c, fc, share = a, fa, 0.5
    while True:  # a is the newest place, the root between a and b, c what was dropped last
        best, least = (a, abs(fa)) if abs(fa) < abs(fb) else (b, abs(fb))
        close = (xtol + rtol * abs(best)) / abs(b - a) if b != a else 1.0
        if least == 0.0 or close > 0.5:
            return best
        share = min(max(share, close), 1.0 - close)
        x = a + share * (b - a)
        fx = float(f(x))
        if (fx > 0.0) == (fa > 0.0):
            c, fc, a, fa = a, fa, x, fx
        else:
            c, fc, b, fb, a, fa = b, fb, a, fa, x, fx
        share = _share(a, fa, b, fb, c, fc)


def _share(a: float, fa: float, b: float, fb: float, c: float, fc: float) -> float:
    """Where to go on between a and b."""
    place, height = (a - b) / (c - b), (fa - fb) / (fc - fb)
    if not (height * height < place and (1.0 - height) ** 2 < 1.0 - place):
        return 0.5
    return fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
