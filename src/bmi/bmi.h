#pragma once

#include <string>
#include <vector>

/// The Basic Model Interface, version 2.0 (Hutton, Piper & Tucker 2020, Journal of Open Source
/// Software 5, 2317): the names and signatures of its C++ binding, so that what couples models by
/// that binding takes these.
namespace bmi {

// NOLINTBEGIN(performance-unnecessary-value-param,readability-avoid-const-params-in-decls,readability-identifier-naming):
// the signatures are the specification's.

/// A model that another program starts, steps, asks and changes. Arrays are the caller's, as large
/// as the variable or grid asks for. Names are those of GetInputVarNames() and GetOutputVarNames().
class Bmi {
  public:
    Bmi() = default;
    Bmi(const Bmi&) = delete;
    Bmi& operator=(const Bmi&) = delete;
    virtual ~Bmi() = default;

    // Its life.
    virtual void Initialize(std::string config_file) = 0;
    virtual void Update() = 0;
    virtual void UpdateUntil(double time) = 0;
    virtual void Finalize() = 0;

    // What it is.
    virtual std::string GetComponentName() = 0;
    virtual int GetInputItemCount() = 0;
    virtual int GetOutputItemCount() = 0;
    virtual std::vector<std::string> GetInputVarNames() = 0;
    virtual std::vector<std::string> GetOutputVarNames() = 0;

    // What a variable is.
    virtual int GetVarGrid(std::string name) = 0;
    virtual std::string GetVarType(std::string name) = 0;
    virtual std::string GetVarUnits(std::string name) = 0;
    virtual int GetVarItemsize(std::string name) = 0;
    virtual int GetVarNbytes(std::string name) = 0;
    virtual std::string GetVarLocation(std::string name) = 0;

    // Its time.
    virtual double GetCurrentTime() = 0;
    virtual double GetStartTime() = 0;
    virtual double GetEndTime() = 0;
    virtual std::string GetTimeUnits() = 0;
    virtual double GetTimeStep() = 0;

    // Values.
    virtual void GetValue(std::string name, void* dest) = 0;
    virtual void* GetValuePtr(std::string name) = 0;
    virtual void GetValueAtIndices(std::string name, void* dest, int* inds, int count) = 0;
    virtual void SetValue(std::string name, void* src) = 0;
    virtual void SetValueAtIndices(std::string name, int* inds, int count, void* src) = 0;

    // Grids.
    virtual int GetGridRank(const int grid) = 0;
    virtual int GetGridSize(const int grid) = 0;
    virtual std::string GetGridType(const int grid) = 0;
    virtual void GetGridShape(const int grid, int* shape) = 0;
    virtual void GetGridSpacing(const int grid, double* spacing) = 0;
    virtual void GetGridOrigin(const int grid, double* origin) = 0;
    virtual void GetGridX(const int grid, double* x) = 0;
    virtual void GetGridY(const int grid, double* y) = 0;
    virtual void GetGridZ(const int grid, double* z) = 0;
    virtual int GetGridNodeCount(const int grid) = 0;
    virtual int GetGridEdgeCount(const int grid) = 0;
    virtual int GetGridFaceCount(const int grid) = 0;
    virtual void GetGridEdgeNodes(const int grid, int* edge_nodes) = 0;
    virtual void GetGridFaceEdges(const int grid, int* face_edges) = 0;
    virtual void GetGridFaceNodes(const int grid, int* face_nodes) = 0;
    virtual void GetGridNodesPerFace(const int grid, int* nodes_per_face) = 0;
};

// NOLINTEND(performance-unnecessary-value-param,readability-avoid-const-params-in-decls,readability-identifier-naming)

}  // namespace bmi
