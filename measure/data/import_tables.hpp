#pragma once

#include <functional>
#include <vector>

#include "measure/data/import_files.hpp"
#include "measure/data/line_row.hpp"

namespace secular {

/// Takes the tables one after another; the entry is one of kind `lines` without a row.
using TableSink =
    std::function<void(const Campaign& campaign, const RecordEntry& entry, const std::vector<LineRow>& rows)>;

/// Reads files as tables of lines (--kind lines). `*` in the name of a variable, as in run(*).force, stands for all
/// numbers that the file has there: a table each. An excitation that the file has no column of has the level that
/// is given. Throws InputError as import_files does.
ImportedCampaign import_tables(const ImportOptions& options, const TableSink& sink);

}  // namespace secular
