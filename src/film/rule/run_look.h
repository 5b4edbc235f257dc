#pragma once

#include <string>

#include "film/beds/film_runs.h"

namespace fumon {

/// What a film by rule takes from a run: where its time goes, where light and camera stand well,
/// and what is worth a close look.
struct RunLook {
    bool changes = false;  ///< more than one bed is stored
    bool shaped = false;   ///< the bed itself changes to the eye
    int begin = 0;   ///< per cent of the stored steps: where water lies that is there at first
                     ///< alone, past that
    int early = 30;  ///< per cent of the stored steps, by which a third of the change is over
    int late = 80;   ///< likewise, four fifths of it
    bool endless = false;           ///< its ground is drawn to the horizon
    bool widened = false;           ///< which its own scene does not ask for
    bool land = false;              ///< a survey, which stands on a table in its own scene
    bool showery = false;           ///< it rains on that land, and its own scene has no clouds
    bool flood = false;             ///< water deeper than the relief of its bed
    bool section = false;           ///< air over a profile
    double camera_azimuth = 205.0;  ///< degrees
    double sun_azimuth = 285.0;     ///< degrees, across the relief
    double sun_elevation = 16.0;    ///< degrees
    bool own_sun = false;           ///< the scene has the sun of a place and a time
    double wavelength = 0.25;  ///< of the last bed's relief along its shorter waves, block lengths
    double breadth = 0.25;     ///< of what is looked at closely, block lengths
    std::string largest;       ///< what is looked at closely, as a film's subject
    std::string title;         ///< the scene's, or its terrain file's name
};

/// Looks at some of a run's stored beds. The camera stands where the wind comes from its left, or
/// on the lower side of a slope; the light comes from the wind's side, or from the side from which
/// it varies more over the last bed, at half of the slope that nine tenths of its cells do not
/// exceed, 20° to 33°, from 14° on over dunes. The same
/// beds give the same look on any machine. Throws InputError for a damaged run.
RunLook look_at_run(const StoredBeds& beds);

}  // namespace fumon
