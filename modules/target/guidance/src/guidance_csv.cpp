#include "facenav/guidance/guidance_csv.h"

#include "facenav/core/csv_table.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"

namespace facenav::guidance {
std::string guidanceCsvHeader() {
  return "frame,t_s,target,state,distance_mm,lateral_mm,depth_mm,tilt_deg,twist_deg,beam_miss_mm,"
         "predicted_error_mm,gap_mm,gap_stereo_mm\n";
}

std::string toCsvLine(const GuidanceRow& row) {
  std::string line = std::to_string(row.frame) + "," + fixed(row.t_s, 6) + "," + csvField(row.target) + "," +
                     toString(row.state.state);
  if (!row.state.values) return line + ",,,,,,,,,\n";
  const GuidanceValues& values = *row.state.values;
  for (const double value :
       {values.distance_mm, values.lateral_mm, values.depth_mm, values.tilt_rad * kDegPerRad,
        values.twist_rad * kDegPerRad, values.beam_miss_mm, row.state.predicted_error_mm})
    line += "," + fixed(value, 4);
  for (const auto& gap_mm : {row.gap.by_poses_mm, row.gap.byStereo_mm()})
    line += "," + (gap_mm ? fixed(*gap_mm, 2) : std::string());
  return line + "\n";
}

void writeGuidanceCsv(const std::vector<GuidanceRow>& rows, const std::filesystem::path& path) {
  std::string content = guidanceCsvHeader();
  for (const GuidanceRow& row : rows) content += toCsvLine(row);
  writeWholeFile(path, content);
}

}  // namespace facenav::guidance
