#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "picture/png.h"

namespace fumon {

/// A picture's texts as XMP (ISO 16684-1): "Title" as dc:title, "Software" as xmp:CreatorTool, and
/// those of fumon ("fumon:scene") under their own names in the namespace "urn:fumon:picture:". A
/// character that XML cannot hold becomes "?". Throws Error for other keywords.
std::string xmp_packet(const PictureText& texts);

/// The same as packets of at most so many bytes: a packet, and what did not fit in it as XMP
/// without a wrapper, of any length, of which the packet names the `guid` (ExtendedXMP of XMP's
/// part 3; empty: all fits).
struct XmpParts {
    std::string packet;
    std::string extension;
    std::string guid;
};
XmpParts xmp_parts(const PictureText& texts, std::size_t most_bytes);

/// The texts of such XMP in their order, also where another program has written it anew, with
/// attributes for elements. Never throws: of what is not XMP there are none.
PictureText texts_of_xmp(std::string_view xmp);

/// A text as it stands in XML, with line ends escaped; a character that XML cannot hold becomes
/// "?".
std::string xml_escaped(std::string_view text);

/// The value of an element that holds text alone, or of an attribute, by its name with prefix
/// ("pdf:Keywords"); the last where there are several, empty where there is none. Never throws.
std::string xmp_value(std::string_view xmp, std::string_view name);

/// The GUID of the extension that a packet names; empty where it names none.
std::string extension_of_xmp(std::string_view xmp);

}  // namespace fumon
