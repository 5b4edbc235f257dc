#include "files/gdal/vector_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// GDAL's drivers of vector files; of unknown origin those whose formats name no other file.
std::span<const char* const> vector_drivers(bool trusted) {
    static constexpr std::array<const char*, 3> alone{"GeoJSON", "FlatGeobuf", nullptr};
    static constexpr std::array<const char*, 8> all{
        "GeoJSON", "GPKG", "ESRI Shapefile", "FlatGeobuf", "LIBKML", "KML", "GML", nullptr};
    if (trusted) return all;
    return alone;
}

/// A geometry's type in two dimensions.
unsigned int flat_type(OGRGeometryH geometry) {
    constexpr unsigned int high_bit = 0x80000000U;
    constexpr unsigned int of_dimensions = 1000U;
    return (static_cast<unsigned int>(gdal().OGR_G_GetGeometryType(geometry)) & ~high_bit) %
           of_dimensions;
}

class VectorReader {
  public:
    VectorReader(const fs::path& file, const VectorQuery& query)
        : query_(query),
          session_(query.trusted ? GdalSession::Siblings::by_name : GdalSession::Siblings::none),
          dataset_(gdal().GDALOpenEx(fs::absolute(file).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                     vector_drivers(query.trusted).data(), nullptr, nullptr)) {
        if (dataset_.get() == nullptr || !session_.fault().empty()) refuse_damage();
    }

    VectorLayer read() {
        OGRLayerH layer = chosen_layer();
        const int field = query_.label.empty() ? -1 : label_field(layer);
        if (!query_.where.empty() &&
            gdal().OGR_L_SetAttributeFilter(layer, query_.where.c_str()) != OGRERR_NONE) {
            throw KeyError("where",
                           fmt::format("does not take \"{}\": {}; write a condition on its fields, "
                                       "\"kind = 'stream'\"",
                                       query_.where, session_.fault()));
        }
        VectorLayer result;
        if (OGRSpatialReferenceH reference = gdal().OGR_L_GetSpatialRef(layer);
            reference != nullptr) {
            constexpr std::array<const char*, 3> form{"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
            char* text = nullptr;
            if (gdal().OSRExportToWktEx(reference, &text, form.data()) == OGRERR_NONE &&
                text != nullptr)
                result.crs = text;
            gdal().VSIFree(text);
        }
        while (OGRFeatureH feature = gdal().OGR_L_GetNextFeature(layer)) {
            const OwnFeature owned(feature);
            ++number_;
            OGRGeometryH geometry = gdal().OGR_F_GetGeometryRef(feature);
            if (geometry == nullptr) continue;
            VectorFeature read = feature_of(geometry);
            if (read.parts.empty()) continue;
            if (field >= 0 && gdal().OGR_F_IsFieldSetAndNotNull(feature, field) != 0)
                read.label = gdal().OGR_F_GetFieldAsString(feature, field);
            result.features.push_back(std::move(read));
        }
        if (!session_.fault().empty()) refuse_damage();
        return result;
    }

  private:
    class OwnFeature {
      public:
        explicit OwnFeature(OGRFeatureH handle) : handle_(handle) {}
        ~OwnFeature() { gdal().OGR_F_Destroy(handle_); }
        OwnFeature(const OwnFeature&) = delete;
        OwnFeature& operator=(const OwnFeature&) = delete;

      private:
        OGRFeatureH handle_;
    };

    [[noreturn]] void refuse_damage() const {
        const std::string& fault = session_.fault();
        throw InputError(fmt::format(
            "cannot be read as lines, points or areas{}{}; name a GeoJSON, GeoPackage or shapefile",
            fault.empty() ? "" : ": ", fault));
    }

    [[nodiscard]] OGRLayerH chosen_layer() const {
        const int count = gdal().GDALDatasetGetLayerCount(dataset_.get());
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) {
            OGRLayerH layer = gdal().GDALDatasetGetLayer(dataset_.get(), i);
            names.emplace_back(gdal().OGR_L_GetName(layer));
            if (query_.name.empty() ? count == 1 : names.back() == query_.name) return layer;
        }
        if (names.empty()) throw InputError("holds no layer of lines, points or areas");
        if (query_.name.empty()) {
            throw KeyError("name", fmt::format("holds {} layers; name one: {}", count,
                                               fmt::join(names, ", ")));
        }
        throw KeyError("name", fmt::format("has no layer \"{}\"; {}", query_.name,
                                           suggestion(query_.name, names)));
    }

    [[nodiscard]] int label_field(OGRLayerH layer) const {
        OGRFeatureDefnH definition = gdal().OGR_L_GetLayerDefn(layer);
        std::vector<std::string> names;
        for (int i = 0; i < gdal().OGR_FD_GetFieldCount(definition); ++i) {
            names.emplace_back(
                gdal().OGR_Fld_GetNameRef(gdal().OGR_FD_GetFieldDefn(definition, i)));
            if (names.back() == query_.label) return i;
        }
        if (names.empty()) {
            throw KeyError("label",
                           fmt::format("has no field \"{}\", and no other one", query_.label));
        }
        throw KeyError("label", fmt::format("has no field \"{}\"; {}", query_.label,
                                            suggestion(query_.label, names)));
    }

    [[nodiscard]] VectorFeature feature_of(OGRGeometryH geometry) {
        if (gdal().OGR_G_HasCurveGeometry(geometry, 0) == 0) return straight_feature_of(geometry);
        OGRGeometryH straight = gdal().OGR_G_GetLinearGeometry(geometry, 0.0, nullptr);
        if (straight == nullptr) refuse_damage();
        try {
            VectorFeature feature = straight_feature_of(straight);
            gdal().OGR_G_DestroyGeometry(straight);
            return feature;
        } catch (...) {
            gdal().OGR_G_DestroyGeometry(straight);
            throw;
        }
    }

    [[nodiscard]] VectorFeature straight_feature_of(OGRGeometryH geometry) {
        VectorFeature feature;
        switch (flat_type(geometry)) {
            case wkbPoint:
            case wkbMultiPoint:
                feature.shape = VectorShape::points;
                break;
            case wkbLineString:
            case wkbMultiLineString:
                feature.shape = VectorShape::lines;
                break;
            case wkbPolygon:
            case wkbMultiPolygon:
                feature.shape = VectorShape::areas;
                break;
            case wkbGeometryCollection:
                refuse("a geometry collection",
                       "split it into points, lines and areas (ogr2ogr -explodecollections)");
            default:
                refuse("neither points, lines nor areas", "bring it to these (ogr2ogr -nlt)");
        }
        add_parts(geometry, feature);
        return feature;
    }

    [[noreturn]] void refuse(std::string_view what, std::string_view remedy) const {
        throw InputError(fmt::format("feature {} is {}; {}", number_, what, remedy));
    }

    void add_parts(OGRGeometryH geometry, VectorFeature& feature) {
        const int parts = gdal().OGR_G_GetGeometryCount(geometry);
        for (int i = 0; i < parts; ++i)
            add_parts(gdal().OGR_G_GetGeometryRef(geometry, i), feature);
        if (parts > 0) return;
        const int count = gdal().OGR_G_GetPointCount(geometry);
        points_ += count;
        if (points_ > query_.most_points) {
            throw InputError(fmt::format("has more than {} points; simplify it (ogr2ogr -simplify)",
                                         query_.most_points));
        }
        std::vector<VectorPoint> part;
        part.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            const VectorPoint point{gdal().OGR_G_GetX(geometry, i), gdal().OGR_G_GetY(geometry, i)};
            if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
                refuse("at no finite place", "mend it (ogr2ogr -makevalid)");
            part.push_back(point);
        }
        if (!part.empty()) feature.parts.push_back(std::move(part));
    }

    const VectorQuery& query_;
    GdalSession session_;
    GdalDataset dataset_;
    long long number_ = 0;  ///< of the feature, from 1
    long long points_ = 0;
};

}  // namespace

VectorLayer read_vector_layer(const fs::path& file, const VectorQuery& query) {
    if (const std::string missing = missing_gdal(); !missing.empty())
        throw InputError("a layer of lines, points or areas " + missing);
    return VectorReader(file, query).read();
}

}  // namespace fumon
