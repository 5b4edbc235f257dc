#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bmi/bmi.h"
#include "bmi/coupled_model.h"

namespace fumon {

/// Any model of fumon as a component of the Basic Model Interface: Initialize() takes a scene's
/// file, or the name of a scene that fumon ships. Members throw Error, of what is asked wrongly
/// InputError.
///
///     grid 0   "uniform_rectilinear": the cells' centres, rank 2, (ny, nx), row 0 southernmost;
///              its spacing and origin in metres, or sites
///     grid 1   "scalar": the scene's numbers
///
/// Values are double. A pointer of GetValuePtr() shows what the model has after each step and each
/// change, until Finalize(), and stays valid as long as the component; what is written there
/// changes nothing.
class BmiComponent : public bmi::Bmi {
  public:
    BmiComponent() = default;

    void Initialize(std::string config_file) override;
    void Update() override;
    /// To the step whose end is nearest to a time: models take whole steps.
    void UpdateUntil(double time) override;
    void Finalize() override;

    std::string GetComponentName() override;
    int GetInputItemCount() override;
    int GetOutputItemCount() override;
    std::vector<std::string> GetInputVarNames() override;
    std::vector<std::string> GetOutputVarNames() override;

    int GetVarGrid(std::string name) override;
    std::string GetVarType(std::string name) override;
    std::string GetVarUnits(std::string name) override;
    int GetVarItemsize(std::string name) override;
    int GetVarNbytes(std::string name) override;
    std::string GetVarLocation(std::string name) override;

    double GetCurrentTime() override;
    double GetStartTime() override;
    double GetEndTime() override;
    std::string GetTimeUnits() override;
    double GetTimeStep() override;

    void GetValue(std::string name, void* dest) override;
    void* GetValuePtr(std::string name) override;
    void GetValueAtIndices(std::string name, void* dest, int* inds, int count) override;
    void SetValue(std::string name, void* src) override;
    void SetValueAtIndices(std::string name, int* inds, int count, void* src) override;

    int GetGridRank(int grid) override;
    int GetGridSize(int grid) override;
    std::string GetGridType(int grid) override;
    void GetGridShape(int grid, int* shape) override;
    void GetGridSpacing(int grid, double* spacing) override;
    void GetGridOrigin(int grid, double* origin) override;
    void GetGridX(int grid, double* x) override;
    void GetGridY(int grid, double* y) override;
    /// Of a grid of rank 2 there is none: throws InputError.
    void GetGridZ(int grid, double* z) override;
    int GetGridNodeCount(int grid) override;
    /// Edges: those along x, row by row, then those along y. Faces: row by row.
    int GetGridEdgeCount(int grid) override;
    int GetGridFaceCount(int grid) override;
    void GetGridEdgeNodes(int grid, int* edge_nodes) override;
    void GetGridFaceEdges(int grid, int* face_edges) override;
    void GetGridFaceNodes(int grid, int* face_nodes) override;
    void GetGridNodesPerFace(int grid, int* nodes_per_face) override;

  private:
    CoupledModel& model();
    const Variable& variable(const std::string& name);
    int items(const std::string& name);
    /// Whether a grid is that of the cells; InputError for one that there is not.
    bool is_raster(int grid);
    void need_raster(int grid, const char* what);
    void refresh();

    std::unique_ptr<CoupledModel> model_;
    std::map<std::string, std::vector<double>> shown_;  ///< whose memory pointers were given out
    std::vector<std::vector<double>> previous_;         ///< the same, of models that are gone
};

}  // namespace fumon
