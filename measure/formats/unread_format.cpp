#include "measure/formats/unread_format.hpp"

#include <algorithm>
#include <iterator>

#include "measure/formats/file_bytes.hpp"

namespace secular {
namespace {

using namespace std::string_view_literals;

/// `begin` stands at the begin of the file, `inside` in its first bytes; each may be empty. Where no bytes tell a
/// format, its files' names do.
struct KnownBegin {
  std::string_view begin, inside, extension;
  UnreadFormat format;
};

constexpr KnownBegin known_begins[] = {
    {"PK\x03\x04"sv, "opendocument", "", {"an OpenDocument spreadsheet", "save the sheet as CSV"}},
    {"PK\x03\x04"sv,
     ".npy",
     "",
     {"a NumPy archive (npz)", "in Python: scipy.io.savemat('NAME.mat', dict(numpy.load('NAME.npz')))"}},
    {"PK\x03\x04"sv, "", ".xlsx", {"an Excel workbook", "save the sheet as CSV"}},
    {"PK\x03\x04"sv, "", ".xlsm", {"an Excel workbook", "save the sheet as CSV"}},
    {"PK\x03\x04"sv, "", "", {"a zip archive", "unpack it"}},
    {"\x1f\x8b"sv, "", "", {"a file compressed by gzip", "unpack it: gunzip NAME"}},
    {"\xd0\xcf\x11\xe0"sv,
     "",
     "",
     {"an Excel workbook of the old kind or another OLE file", "save the sheet as CSV"}},
    {"PAR1"sv,
     "",
     "",
     {"a Parquet file", "in Python: pandas.read_parquet('NAME').to_csv('NAME.csv', index=False)"}},
    {"ARROW1"sv,
     "",
     "",
     {"a Feather file", "in Python: pandas.read_feather('NAME').to_csv('NAME.csv', index=False)"}},
    {"FEA1"sv,
     "",
     "",
     {"a Feather file", "in Python: pandas.read_feather('NAME').to_csv('NAME.csv', index=False)"}},
    {"\x93NUMPY"sv,
     "",
     "",
     {"a NumPy array", "in Python: scipy.io.savemat('NAME.mat', {'data': numpy.load('NAME.npy')})"}},
    {"MDF "sv, "", "", {"an MDF measurement file", "in Python: asammdf.MDF('NAME').export('mat', 'NAME.mat')"}},
    {"UnFinMF "sv, "", "", {"an MDF measurement file", "in Python: asammdf.MDF('NAME').export('mat', 'NAME.mat')"}},
    {"TDSm"sv,
     "",
     "",
     {"a TDMS file (LabVIEW, DIAdem)",
      "in Python: nptdms.TdmsFile.read('NAME').as_dataframe(time_index=True).to_csv('NAME.csv')"}},
    {"TDSh"sv, "", "", {"the index of a TDMS file", "export the TDMS file beside it as CSV"}},
    {""sv, "<usi:tdm", "", {"the header of a DIAdem TDM file", "export the channels as CSV or LVM from DIAdem"}},
    {""sv, "", ".tdx", {"the binary half of a DIAdem TDM file", "export the channels as CSV or LVM from DIAdem"}},
    {"|CF,"sv, "", "", {"an imc FAMOS file", "export it as CSV or MAT from FAMOS"}},
    {""sv, "", ".dxd", {"a Dewesoft data file", "export it as CSV, MAT or UNV from Dewesoft"}},
    {""sv, "", ".d7d", {"a Dewesoft data file", "export it as CSV, MAT or UNV from Dewesoft"}},
    {""sv, "", ".svd", {"a Polytec scan", "export it as universal file (UFF) from PSV"}},
    {""sv, "", ".pvd", {"a Polytec measurement", "export it as universal file (UFF) or text"}},
    {""sv,
     "",
     ".sac",
     {"a SAC seismogram",
      "in Python: obspy.read('NAME').write('NAME.wav', format='WAV'), or numpy.savetxt of its samples"}},
    {"MS\x03"sv,
     "",
     "",
     {"a miniSEED file",
      "in Python: numpy.savetxt('NAME.csv', obspy.read('NAME')[0].data), then give --sample-rate HZ"}},
    {"SQLite format 3"sv, "", "", {"an SQLite database", "export the table as CSV"}},
    {"Octave-1-"sv, "", "", {"an Octave binary file", "in Octave: save -v7 NAME.mat"}},
};

constexpr UnreadFormat mini_seed = {
    "a miniSEED file",
    "in Python: numpy.savetxt('NAME.csv', obspy.read('NAME')[0].data), then give --sample-rate HZ"};
constexpr UnreadFormat json = {"JSON text", "in Python: pandas.read_json('NAME').to_csv('NAME.csv', index=False)"};

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

// "000001D ": a sequence number, the kind of record and a blank.
bool begins_as_mini_seed(std::string_view bytes) {
  return bytes.size() > 48 && bytes.substr(0, 6).find_first_not_of("0123456789") == std::string_view::npos &&
         "DRQM"sv.find(bytes[6]) != std::string_view::npos && bytes[7] == ' ' &&
         bytes.find('\0') != std::string_view::npos;
}

// { "a": or [1, or [{: no name of a column begins so.
bool begins_as_json(std::string_view bytes) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t open = bytes.find_first_not_of(blanks);
  if (open == std::string_view::npos || (bytes[open] != '{' && bytes[open] != '[')) return false;
  const std::size_t next = bytes.find_first_not_of(blanks, open + 1);
  if (next == std::string_view::npos) return false;
  return bytes[open] == '{' ? bytes[next] == '"' : "[{-0123456789"sv.find(bytes[next]) != std::string_view::npos;
}

}  // namespace

const UnreadFormat* unread_format(const std::filesystem::path& path) {
  constexpr std::size_t looked_at = 1024;
  const std::string bytes = some_bytes(path, looked_at), extension = lower_case_extension(path);
  const auto found = std::find_if(std::begin(known_begins), std::end(known_begins), [&](const KnownBegin& known) {
    return bytes.starts_with(known.begin) && bytes.find(known.inside) != std::string::npos &&
           (known.extension.empty() || known.extension == extension);
  });
  if (found != std::end(known_begins)) return &found->format;
  if (begins_as_mini_seed(bytes)) return &mini_seed;
  return begins_as_json(bytes) ? &json : nullptr;
}

}  // namespace secular
