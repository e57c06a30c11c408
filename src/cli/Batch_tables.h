// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_BATCH_TABLES_H
#define REEBQUAD_CLI_BATCH_TABLES_H

#include "Batch_record.h"

#include <string>
#include <vector>

namespace reebquad {

/// A row of the tables: a mesh and what became of it.
struct Batch_row {
  Batch_job job;
  std::optional<Batch_record> record; ///< none: it is not done yet
  std::string folder;                 ///< of its results
};

/// One line for each mesh, in the order of the rows, after a line of names; RFC 4180.
std::string csv_table(const std::vector<Batch_row>& rows);

/// The records, one in a line; of a mesh that is not done its name and the outcome "pending".
std::string json_lines(const std::vector<Batch_row>& rows);

/// One file that shows in any browser, without a network, the `limit` rows that need a person first: what
/// failed, is in part, has warnings; with thumbnails, sortable by column. `results` is where the file will
/// lie; links lead to the meshes' folders from there.
std::string html_overview(std::vector<Batch_row> rows, const std::string& results, std::size_t limit);

} // namespace reebquad

#endif // REEBQUAD_CLI_BATCH_TABLES_H
