// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_BATCH_RECORD_H
#define REEBQUAD_CLI_BATCH_RECORD_H

#include "Batch_jobs.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reebquad {

/// What became of one mesh of a collection. A mesh is done when its folder of results has such a record of
/// the input as it is and of what is asked now.
struct Batch_record {
  std::string name, file; ///< of the job; both in one printable line
  /// \name The input, as it was before it was read
  /// @{
  std::uint64_t size = 0;
  std::int64_t modified = 0; ///< nanoseconds
  std::string digest;        ///< of its bytes
  /// @}
  std::vector<std::string> request; ///< what the results depend on: their format, options of run
  std::string version;              ///< of the program
  std::string outcome;              ///< "certified", "in part" or "failed"
  std::string sentence;             ///< the last that was said: why it failed, or what is left out
  std::vector<std::string> warnings;
  int exit_code = 0; ///< as a shell gives it
  double seconds = 0, cpu_seconds = 0, peak_megabytes = 0;
  /// \name From the report of the run; zero where there is none
  /// @{
  int points = 0, faces = 0, components = 0, quads = 0, extraordinary = 0;
  double worst_jacobian = 0, mean_jacobian = 0;
  double distance = 0; ///< between input and quads at most, in parts of the diagonal
  /// @}

  bool is_good() const { return outcome == "certified"; }
  bool is_failed() const { return outcome == "failed"; }
};

/// The record in one line of JSON, its end included.
std::string to_json_line(const Batch_record& record);

/// The record in a file; none if there is no such file or it is no record.
std::optional<Batch_record> read_record(const std::string& file);

/// A record of the file of the job as it is now, without an outcome; a `Failure` if it cannot be read.
Batch_record begin_record(const Batch_job& job, const std::vector<std::string>& request);

/// Whether the record is of the file as it is now: of that size, and of that time or those bytes.
bool is_of(const Batch_record& record, const std::string& file);

/// Fills in what the report of a run tells.
void take_report(const std::string& report_file, Batch_record& record);

} // namespace reebquad

#endif // REEBQUAD_CLI_BATCH_RECORD_H
