#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "paper/figure_plan.h"

namespace fumon {

/// Numbers of rows of a table, from 0.
using TableRows = std::vector<std::size_t>;

/// The rows that meet a curve's conditions, missing data among them. Throws InputError without a
/// place for a wrong condition.
TableRows chosen_rows(const Table& table, const CurveSettings& settings);

/// Of these rows those of each value of settings.group_by, in the order in which the values come
/// up, or all; no group in which no row has numbers in x and y.
std::vector<TableRows> groups_of_rows(const Table& table, const CurveSettings& settings,
                                      const TableRows& rows);

/// Which run each row of a curve's table comes from; of a file's, each row its own.
std::vector<std::size_t> runs_of_rows(const CurvePlan& curve, const Table& table);

/// Throws InputError for an infinite number in a curve's columns of a file; empty cells and nan are
/// missing data, but what is infinite is a slip of who computed it.
void refuse_infinities(const Table& table, const CurveSettings& settings, const std::string& file);

/// How the legend calls the curve of these rows; empty for not at all.
std::string curve_name(const CurvePlan& curve, const Table& table, const TableRows& rows);

}  // namespace fumon
