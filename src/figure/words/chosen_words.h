#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figure/words/words.h"
#include "scene/scene.h"

namespace fumon {

/// The words in which pictures are written: those of image.language, with those of
/// image.words in their place. Null: English. Throws KeyError for a language that there is not.
std::shared_ptr<const WordTable> picture_words(const ImageSettings& image);

/// The same of its figure: figure.language, or that of its pictures. `own` is the text of the file
/// that figure.words names, empty where that names none.
std::shared_ptr<const WordTable> figure_words(const Scene& scene, const std::string& own);

/// Puts the entries of files that image.words names in the place of their names, so that a scene
/// needs no file. Throws InputError, located.
void read_picture_words(Scene& scene);

}  // namespace fumon
