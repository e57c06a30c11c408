// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_BATCH_JOBS_H
#define REEBQUAD_CLI_BATCH_JOBS_H

#include <string>
#include <string_view>
#include <vector>

namespace reebquad {

/// A mesh of a collection.
struct Batch_job {
  /// Where its results lie under the folder of results, and what people call it: the path below the folder
  /// that was given, that folder's own name in front. Bytes that are no printable UTF-8, and backslashes,
  /// are written as \xNN. Names are distinct, and none is a folder of another: those that were not end with
  /// '~' and a digest of the file's path.
  std::string name;
  std::string file; ///< absolute
};

/// The text in one printable line: control characters, backslashes and bytes that are no UTF-8 as \xNN.
std::string one_line(std::string_view text);

/// The meshes that the files and folders `inputs` hold, each once, by name: a file as it is, whatever its
/// name; of a folder all files, also in folders in it, whose extension is of a format that is read. What
/// begins with a dot is left out, as is `results`, a folder that may lie in an input. Links to files are
/// followed, links to folders are not. Throws a `Failure` that names what cannot be read.
std::vector<Batch_job> find_jobs(const std::vector<std::string>& inputs, const std::string& results);

/// The jobs of those names. Only where a name does not tell its file are the inputs walked through. Throws
/// a usage error if there is no job of a name.
std::vector<Batch_job> find_named_jobs(const std::vector<std::string>& inputs, const std::string& results,
                                       const std::vector<std::string>& names);

/// Whether the job belongs to share `share` of `shares`, counted from 1: by its name alone, whatever other
/// jobs there are.
bool is_in_share(const Batch_job& job, int share, int shares);

} // namespace reebquad

#endif // REEBQUAD_CLI_BATCH_JOBS_H
