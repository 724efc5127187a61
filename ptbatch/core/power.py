"""Powers of positive numbers, in a form that the processor can take several of at a time.

A number is 2^e m with m near 1: its logarithm to base 2 is e and the series of log m; two to the power of
anything is a whole power of two and the series of the exponential. Both series go on beyond the last digit of
a double.
"""

from math import factorial, log

import numpy as np

from ptbatch.core.jit import inlined, kernel

LN2 = log(2.0)
LOG = tuple(2.0 / (2 * k + 1) / LN2 for k in range(11))  # log2((1 + s) / (1 - s)) / s, by powers of s^2
EXP = tuple(LN2**k / factorial(k) for k in range(14))  # 2^f, by powers of f
BEHIND = 52  # binary digits behind the leading one; the exponent stands before these
ROOT_HALF = 0x3FE6A09E667F3BCD  # sqrt(1/2) as an integer: m lies between it and sqrt(2)
MOST = 1000.0  # and its opposite: exponents of two beyond which a power is not followed


@kernel
def log2(x):
    """Logarithm to base 2 of a positive number."""
    digits = np.float64(x).view(np.int64)
    e = (digits - ROOT_HALF) >> BEHIND
    m = np.int64(digits - (e << BEHIND)).view(np.float64)
    s = (m - 1.0) / (m + 1.0)
    t = s * s
    low = LOG[0] + t * (LOG[1] + t * (LOG[2] + t * (LOG[3] + t * (LOG[4] + t * LOG[5]))))
    high = LOG[6] + t * (LOG[7] + t * (LOG[8] + t * (LOG[9] + t * LOG[10])))
    t2 = t * t
    return e + s * (low + t2 * t2 * t2 * high)


@kernel
def exp2(y):
    """Two to the power of y."""
    y = y if y > -MOST else -MOST
    y = y if y < MOST else MOST
    e = np.floor(y + 0.5)
    f = y - e
    low = EXP[0] + f * (EXP[1] + f * (EXP[2] + f * (EXP[3] + f * (EXP[4] + f * (EXP[5] + f * EXP[6])))))
    high = EXP[7] + f * (EXP[8] + f * (EXP[9] + f * (EXP[10] + f * (EXP[11] + f * (EXP[12] + f * EXP[13])))))
    f2 = f * f
    m = low + f2 * f2 * f2 * f * high
    return np.int64(np.float64(m).view(np.int64) + (np.int64(e) << BEHIND)).view(np.float64)


@inlined
def positive_power(x, exponent):
    """x ** exponent for x > 0."""
    return exp2(exponent * log2(x))


@inlined
def power(z, exponent):
    """The same, complex step carried to first order."""
    p = positive_power(z.real, exponent)
    return p + (z - z.real) * (exponent * p / z.real)
