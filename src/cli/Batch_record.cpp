// SPDX-License-Identifier: GPL-3.0-or-later
#include "Batch_record.h"

#include "Failure.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include "session/Store.h"
#include "view/Bounded_json.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <fstream>
#include <sys/stat.h>
#include <system_error>

namespace reebquad {

using CGAL::Reeb_quadrangulation::read_file;
using CGAL::Reeb_quadrangulation::Result;

namespace {

using Ordered_json = nlohmann::ordered_json;

constexpr int schema = 1;
constexpr std::uint64_t largest_record = std::uint64_t(1) << 20, largest_report = std::uint64_t(1) << 28;

struct File_state {
  std::uint64_t size = 0;
  std::int64_t modified = 0;
};

std::optional<File_state> state_of(const std::string& file) {
  struct stat status;
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return File_state{std::uint64_t(status.st_size),
                    std::int64_t(status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec};
}

/// Of the bytes of a file, piece by piece: each digest is of the one before and the next piece.
std::string digest_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string digest, piece(std::size_t(1) << 20, '\0');
  errno = 0;
  while (stream.read(piece.data(), std::streamsize(piece.size())) || stream.gcount() > 0)
    digest = studio::digest(digest + piece.substr(0, std::size_t(stream.gcount())));
  if (stream.bad() || digest.empty()) return {};
  return digest;
}

} // namespace

std::string to_json_line(const Batch_record& r) {
  const Ordered_json json{{"schema", schema},
                          {"name", r.name},
                          {"outcome", r.outcome},
                          {"exit_code", r.exit_code},
                          {"sentence", r.sentence},
                          {"warnings", r.warnings},
                          {"quads", r.quads},
                          {"extraordinary_vertices", r.extraordinary},
                          {"worst_scaled_jacobian", r.worst_jacobian},
                          {"mean_scaled_jacobian", r.mean_jacobian},
                          {"distance", r.distance},
                          {"seconds", r.seconds},
                          {"cpu_seconds", r.cpu_seconds},
                          {"peak_megabytes", r.peak_megabytes},
                          {"input",
                           {{"file", r.file},
                            {"size", r.size},
                            {"modified", r.modified},
                            {"digest", r.digest},
                            {"points", r.points},
                            {"faces", r.faces},
                            {"components", r.components}}},
                          {"request", r.request},
                          {"version", r.version}};
  return json.dump(-1, ' ', false, Ordered_json::error_handler_t::replace) + '\n';
}

std::optional<Batch_record> read_record(const std::string& file) {
  const Result<std::string> text = read_file(file, largest_record);
  if (!text) return std::nullopt;
  const studio::Json json = studio::parse_bounded(*text, 8);
  try {
    if (json.at("schema") != schema) return std::nullopt;
    const studio::Json& input = json.at("input");
    Batch_record r;
    r.name = json.at("name");
    r.outcome = json.at("outcome");
    r.exit_code = json.at("exit_code");
    r.sentence = json.at("sentence");
    r.warnings = json.at("warnings").get<std::vector<std::string>>();
    r.quads = json.at("quads");
    r.extraordinary = json.at("extraordinary_vertices");
    r.worst_jacobian = json.at("worst_scaled_jacobian");
    r.mean_jacobian = json.at("mean_scaled_jacobian");
    r.distance = json.at("distance");
    r.seconds = json.at("seconds");
    r.cpu_seconds = json.at("cpu_seconds");
    r.peak_megabytes = json.at("peak_megabytes");
    r.file = input.at("file");
    r.size = input.at("size");
    r.modified = input.at("modified");
    r.digest = input.at("digest");
    r.points = input.at("points");
    r.faces = input.at("faces");
    r.components = input.at("components");
    r.request = json.at("request").get<std::vector<std::string>>();
    r.version = json.at("version");
    return r;
  } catch (const studio::Json::exception&) {
    return std::nullopt;
  }
}

Batch_record begin_record(const Batch_job& job, const std::vector<std::string>& request) {
  Batch_record record;
  record.name = job.name;
  record.file = one_line(job.file);
  record.request = request;
  record.version = REEBQUAD_VERSION;
  // What is no regular file is refused by run, with a sentence; the record then is of nothing.
  if (const std::optional<File_state> state = state_of(job.file)) {
    record.size = state->size;
    record.modified = state->modified;
    record.digest = digest_of(job.file);
  }
  return record;
}

bool is_of(const Batch_record& record, const std::string& file) {
  const std::optional<File_state> state = state_of(file);
  if (!state || state->size != record.size) return false;
  return state->modified == record.modified || (!record.digest.empty() && digest_of(file) == record.digest);
}

void take_report(const std::string& report_file, Batch_record& record) {
  const Result<std::string> text = read_file(report_file, largest_report);
  if (!text) return;
  const studio::Json json = studio::parse_bounded(*text, 64);
  try {
    record.points = json.at("input").at("points");
    record.faces = json.at("input").at("faces");
    record.components = int(json.at("components").size());
    if (json.at("statistics").is_null()) return;
    const studio::Json& statistics = json.at("statistics");
    record.quads = statistics.at("quads");
    record.extraordinary = statistics.at("extraordinary_vertices");
    record.worst_jacobian = statistics.at("scaled_jacobian").at("minimum");
    record.mean_jacobian = statistics.at("scaled_jacobian").at("mean");
    for (const studio::Json& warning : json.at("certificate").at("warnings"))
      record.warnings.push_back(one_line(warning.at("text").get<std::string>()));
    const studio::Json& shape = json.at("certificate").at("shape");
    if (!shape.is_null() && shape.at("diagonal") > 0)
      record.distance = shape.at("bound").get<double>() / shape.at("diagonal").get<double>();
  } catch (const studio::Json::exception&) {
    record.warnings.push_back("the report of the run has another form than this program's");
  }
}

} // namespace reebquad
