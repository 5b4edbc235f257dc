#pragma once

namespace fumon {

/// Where a body stands in the sky, degrees.
struct SkyPosition {
    double azimuth = 0.0;    ///< clockwise from true north, 0 … 360
    double elevation = 0.0;  ///< above the horizon, −90 … 90
};

/// The sun's centre as it is seen from a place on Earth at sea level: the low-accuracy sun of Meeus
/// (Astronomical Algorithms, 1998, chapter 25), which is also that of NOAA's solar calculator, with
/// parallax. Within 0.01° of NREL's SPA from 1901 to 2099; the difference of dynamical time from
/// UTC is left out (a minute, which moves the sun among the stars by 0.0007°).
///
/// The elevation is the apparent one: raised by refraction (Sæmundsson 1986, the inverse of
/// Bennett's formula, at 1010 hPa and 10 °C), which fades out between 1° and 4° below the horizon.
///
/// `latitude`, `longitude`: degrees, north and east positive. `days`: from 2000-01-01 12:00 UTC.
/// The bits do not depend on the processor.
SkyPosition sun_position(double latitude, double longitude, double days);

}  // namespace fumon
