#include "facenav/scene/site_layer.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "facenav/scene/palette.h"
#include "scene_text.h"

namespace facenav::scene {
namespace {

constexpr double kSite_mm = 2.0, kNameAbove_mm = 5.0;
constexpr int kName_pt = 11;
constexpr palette::Rgb kSiteColour{0.35, 0.92, 0.5};

}  // namespace

struct SiteLayer::Implementation {
  vtkRenderer* renderer;
  std::vector<vtkSmartPointer<vtkProp3D>> props;
  void clear() {
    for (const auto& prop : props) renderer->RemoveViewProp(prop);
    props.clear();
  }
  void add(vtkSmartPointer<vtkProp3D> prop) {
    prop->PickableOff();
    renderer->AddViewProp(prop);
    props.push_back(std::move(prop));
  }
};

SiteLayer::SiteLayer(NavigationScene& scene)
    : implementation_(std::make_unique<Implementation>(Implementation{scene.renderer(), {}})) {}

SiteLayer::~SiteLayer() { implementation_->clear(); }

void SiteLayer::set(const std::vector<ScalpSite>& sites, double text_scale) {
  auto& layer = *implementation_;
  layer.clear();
  if (sites.empty()) return;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& site : sites) middle += site.point.mm / double(sites.size());
  for (const ScalpSite& site : sites) {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(kSite_mm);
    ball->SetCenter(site.point.mm.data());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    auto dot = vtkSmartPointer<vtkActor>::New();
    dot->SetMapper(mapper);
    dot->GetProperty()->SetColor(kSiteColour[0], kSiteColour[1], kSiteColour[2]);
    layer.add(dot);
    auto name = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    setWords(*name, site.name);
    Eigen::Vector3d at = site.point.mm + kNameAbove_mm * (site.point.mm - middle).normalized();
    name->SetPosition(at.data());
    name->GetTextProperty()->SetFontSize(int(std::lround(kName_pt * text_scale)));
    name->GetTextProperty()->SetColor(kSiteColour[0], kSiteColour[1], kSiteColour[2]);
    name->GetTextProperty()->SetJustificationToCentered();
    layer.add(name);
  }
}

}  // namespace facenav::scene
