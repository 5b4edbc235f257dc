#include "base/limits.h"
#include "keys/keys.h"
#include "scene/view/view_keys.h"

namespace fumon {

namespace {

void list_lens_keys(CameraSettings& camera, KeyTable& table) {
    table.word_or_real("camera.f_number", camera.f_number, {{"pinhole", "everything is sharp"}},
                       {.range = {0.5, 1e6},
                        .help = "f-number of the lens (focal length over diameter), which gives "
                                "depth of field; for beds in metres and the perspective camera"});
    table.real("camera.aperture", camera.aperture,
               {.unit = "m or sites",
                .range = {0, 1e6},
                .help = "diameter of the lens, instead of camera.f_number; a large one makes land "
                        "look like a model on a table; 0: a pinhole"});
    table.word_or_real(
        "camera.focus", camera.focus,
        {{"auto",
          "through the point that camera.look_at or camera.framing looks at; else through the "
          "ground in the middle of the picture"}},
        {.unit = "m or sites",
         .range = {0, largest_coordinate, true},
         .help = "distance from the lens to the plane of focus, along the camera's axis"});
    table.word_or_real(
        "camera.lens_samples", camera.lens_samples,
        {{"auto", "16 to 128, as the widest blur of the ground needs"}},
        {.range = {4, 256}, .help = "points of the lens that the picture is drawn from"});
}

}  // namespace

void list_camera_keys(CameraSettings& camera, KeyTable& table) {
    table.choice(
        "camera.projection", camera.projection,
        {{Projection::perspective, "perspective", "as the eye sees it"},
         {Projection::orthographic, "orthographic", "oblique, parallel lines stay parallel"},
         {Projection::map, "map", "straight from above, north up"}},
        {.help = "how the block is projected"});
    table.choice("camera.framing", camera.framing,
                 {{Framing::block, "block", "around the whole block, or as camera.at says"},
                  {Framing::overview, "overview", "over the bed, down on its landforms"},
                  {Framing::low, "low", "across the crests, from a little above the highest"},
                  {Framing::along_crest, "along-crest", "along the highest crest, from beside it"},
                  {Framing::slip_face, "slip-face", "from downwind, up at the highest crest"},
                  {Framing::aerial, "aerial", "steeply down, as from an aeroplane"}},
                 {.help = "camera position by name, found from the first bed and its wind; views "
                          "stay 10 degrees off the grid's own directions"});
    table.real("camera.azimuth", camera.azimuth,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "where the camera stands, clockwise from north"});
    table.real("camera.elevation", camera.elevation,
               {.unit = "degrees", .range = {1, 89.9}, .help = "above the horizon"});
    table.word_or_real(
        "camera.distance", camera.distance,
        {{"auto",
          "as \"fit\"; where land is invented around the bed (look.ground), nearer: "
          "the bed begins at the picture's lower edge or is as broad as the picture"},
         {"fit", "the whole block just fits the picture"}},
        {.unit = "block lengths",
         .range = {0.05, 100},
         .help = "from the block's centre, in units of its longer side",
         .earlier = {"0.3.0", "\"fit\""}});
    table.real(
        "camera.field_of_view", camera.field_of_view,
        {.unit = "degrees", .range = {2, 120}, .help = "vertical, for the perspective camera"});
    table.word_or_real(
        "camera.focal_length", camera.focal_length, {{"auto", "as camera.field_of_view says"}},
        {.unit = "mm",
         .range = {7, 700},
         .help = "of a lens whose picture is 24 mm high, for the perspective camera"});
    table.real("camera.roll", camera.roll,
               {.unit = "degrees",
                .range = {-180, 180},
                .help = "of the camera to the right, for the perspective camera"});
    table.real(
        "camera.margin", camera.margin,
        {.range = {0, 0.4}, .help = "free border around the fitted block, share of the picture"});
    const char* place =
        "east and north of the bed's south-western corner, and above the bed there: in `fumon "
        "still` that of its step, elsewhere that of the first frame";
    table.real_list(
        "camera.at", camera.at, 0, 3,
        {.unit = "m or sites", .range = {-largest_coordinate, largest_coordinate}, .help = place});
    table.real_list(
        "camera.look_at", camera.look_at, 0, 3,
        {.unit = "m or sites", .range = {-largest_coordinate, largest_coordinate}, .help = place});
    table.real(
        "camera.turn", camera.turn,
        {.unit = "degrees", .range = {-36000, 36000}, .help = "azimuth added evenly over the run"});
    list_lens_keys(camera, table);
}

}  // namespace fumon
