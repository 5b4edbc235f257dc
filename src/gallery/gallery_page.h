#pragma once

#include <string>
#include <vector>

#include "gallery/gallery_item.h"

namespace fumon {

/// What is in the head of a gallery's page.
inline constexpr const char* own_gallery_mark = "content=\"fumon gallery\"";

/// The page of a gallery, HTML made of the template assets/gallery/page.html: it needs its folder
/// "files", gallery.css and gallery.js beside it, and no network.
std::string gallery_page(const std::string& title, const std::vector<GalleryItem>& items);

/// The files beside the page that are the same in all galleries: name and text.
std::vector<GalleryFile> gallery_furniture();

}  // namespace fumon
