#pragma once

#include "files/gdal/gdal_functions.h"

// What tests write rasters with: functions of GDAL's that fumon does not use itself.
extern "C" {
CPLErr GDALCreateDatasetMaskBand(GDALDatasetH dataset, int flags);
char** GDALGetFileList(GDALDatasetH dataset);
void GDALGetBlockSize(GDALRasterBandH band, int* nx, int* ny);
GDALDataType GDALGetDataTypeByName(const char* name);
const char* GDALGetDataTypeName(GDALDataType type);
int GDALGetOverviewCount(GDALRasterBandH band);
CPLErr GDALSetMetadataItem(GDALMajorObjectH object, const char* name, const char* value,
                           const char* domain);
CPLErr GDALSetRasterColorInterpretation(GDALRasterBandH band, GDALColorInterp colour);
CPLErr GDALSetRasterNoDataValueAsInt64(GDALRasterBandH band, std::int64_t value);
CPLErr GDALSetRasterOffset(GDALRasterBandH band, double value);
CPLErr GDALSetRasterScale(GDALRasterBandH band, double value);
CPLErr GDALSetProjection(GDALDatasetH dataset, const char* wkt);
CPLErr GDALSetGCPs(GDALDatasetH dataset, int count, const void* points, const char* wkt);
void CPLSetThreadLocalConfigOption(const char* key, const char* value);
const char* OSRGetAuthorityCode(OGRSpatialReferenceH crs, const char* key);
}
