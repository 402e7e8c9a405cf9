#include "engine/results/export.hpp"
#include "tests/viz/drawn_plate.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>
#include <regex>

namespace rift::viz {
namespace {

using namespace drawn_plate;
namespace fs = std::filesystem;

/// The files that a collection names, with their times.
std::vector<std::pair<double, fs::path>> files_of(const fs::path& pvd) {
  std::ifstream stream(pvd);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::regex entry("<DataSet timestep=\"([^\"]*)\" group=\"\" part=\"0\" file=\"([^\"]*)\"/>");
  std::vector<std::pair<double, fs::path>> files;
  for (std::sregex_iterator it(text.begin(), text.end(), entry); it != std::sregex_iterator(); ++it)
    files.emplace_back(std::stod((*it)[1]), pvd.parent_path() / (*it)[2].str());
  return files;
}

TEST(ExportPvd, IsReadByTheDistributionsVtk) {
  const TemporaryFolder folder;
  const auto files = files_of(results::export_pvd(write_run(folder / "run", 4)));
  ASSERT_EQ(files.size(), 4U);
  const results::Geometry g = geometry();
  for (int moment = 0; moment < 4; ++moment) {
    EXPECT_NEAR(files[moment].first, 1e-6 * moment, 1e-18);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(files[moment].second.c_str());
    reader->Update();
    vtkPolyData& data = *reader->GetOutput();
    ASSERT_EQ(data.GetNumberOfPoints(), columns * rows);
    EXPECT_EQ(data.GetNumberOfVerts(), columns * rows);
    ASSERT_EQ(data.GetNumberOfLines(), static_cast<vtkIdType>(g.beam.size()));
    const results::Frame shown = frame(moment);
    vtkDataArray* displacement = data.GetPointData()->GetArray("displacement");
    vtkDataArray* velocity = data.GetPointData()->GetArray("velocity");
    vtkDataArray* factor = data.GetCellData()->GetArray("damage_factor");
    ASSERT_TRUE(displacement != nullptr && velocity != nullptr && factor != nullptr);
    for (int i = 0; i < columns * rows; ++i) {
      EXPECT_EQ(static_cast<float>(data.GetPoint(i)[1]), g.position[i][1]);
      EXPECT_EQ(static_cast<float>(displacement->GetComponent(i, 1)), shown.displacement[i][1]);
      EXPECT_EQ(static_cast<float>(velocity->GetComponent(i, 0)), shown.velocity[i][0]);
    }
    ASSERT_FALSE(g.crossing.empty());
    for (std::size_t k = 0; k < g.crossing.size(); ++k)
      EXPECT_EQ(static_cast<float>(factor->GetTuple1(columns * rows + g.crossing[k])),
                shown.damage_factor[k]);
  }
}

}  // namespace
}  // namespace rift::viz
