// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of CGAL's demo of polyhedra: the operation "Quadrangulate (Reeb atlas)" makes quads of the
// triangle mesh that is selected.
#include <CGAL/Reeb_quadrangulation/certify_quads.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate_components.h>

#include <CGAL/boost/graph/helpers.h>

#include "Scene_surface_mesh_item.h"

#include <CGAL/Three/Polyhedron_demo_plugin_interface.h>
#include <CGAL/Three/Scene_interface.h>
#include <CGAL/Three/Three.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QMainWindow>
#include <QProgressDialog>
#include <QSpinBox>
#include <QThread>

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RQ = CGAL::Reeb_quadrangulation;
using CGAL::Three::Three;

/// What the dialog asks for, in the words of the program's options.
struct Request {
  int quads = 3000;
  QString effort = "default"; ///< fast, default or best
  double feature_angle = 45;  ///< degrees; 0: none
  QString mirror = "none";    ///< none, auto, x, y or z
  /// Quads keep the edges that the item has as its features ("Detect sharp edges"), instead of those of the
  /// angle.
  bool item_features = false;
};

bool read_effort(const QString& word, RQ::Effort& effort) {
  if (word == "fast")
    effort = RQ::Effort::fast;
  else if (word == "default")
    effort = RQ::Effort::normal;
  else if (word == "best")
    effort = RQ::Effort::best;
  else
    return false;
  return true;
}

bool read_mirror(const QString& word, std::optional<RQ::Mirror_request>& mirror) {
  if (word == "none") return true;
  mirror.emplace();
  if (word == "x")
    mirror->choice = RQ::Mirror_choice::across_x;
  else if (word == "y")
    mirror->choice = RQ::Mirror_choice::across_y;
  else if (word == "z")
    mirror->choice = RQ::Mirror_choice::across_z;
  else if (word != "auto")
    return false;
  return true;
}

/// The options of a run, or a sentence that says what is wrong.
bool read_options(const Request& request, RQ::Quadrangulation_options& options, QString& error) {
  options.quads = request.quads;
  options.features.feature_angle = request.feature_angle;
  options.keep_features = request.item_features || request.feature_angle > 0;
  if (!read_effort(request.effort, options.effort)) {
    error = "there is no effort '" + request.effort + "', but fast, default and best";
    return false;
  }
  if (!read_mirror(request.mirror, options.mirror)) {
    error = "there is no mirror '" + request.mirror + "', but none, auto, x, y and z";
    return false;
  }
  if (options.mirror && request.item_features) {
    error = "features of the item cannot be kept together with a mirror";
    return false;
  }
  return true;
}

/// Shows how far a run has come; its button cancels.
class Progress : public RQ::Observer {
public:
  explicit Progress(QWidget* parent) : m_dialog("Quadrangulating", "Cancel", 0, 100, parent) {
    m_dialog.setWindowModality(Qt::ApplicationModal); // nobody may close the item that is worked on
    m_dialog.setMinimumDuration(1000);
    m_dialog.setAutoClose(false);
    m_dialog.setAutoReset(false);
    m_since_events.start();
  }
  void progress(const std::string& stage, double fraction) override {
    m_dialog.setLabelText(QString::fromStdString(stage));
    m_dialog.setValue(int(100 * fraction));
    handle_events();
  }
  // Stages may be long, and tell no progress: it is here that the dialog appears and its button is pressed.
  bool cancelled() const override {
    if (QThread::currentThread() == m_dialog.thread()) handle_events(); // several threads ask
    return m_cancelled;
  }

private:
  void handle_events() const {
    if (m_since_events.elapsed() < 50) return;
    // Before the dialog is there to block the other windows, no user may do anything.
    QApplication::processEvents(m_dialog.isVisible() ? QEventLoop::AllEvents
                                                     : QEventLoop::ExcludeUserInputEvents);
    m_since_events.restart();
    if (m_dialog.wasCanceled()) m_cancelled = true;
  }

  QProgressDialog m_dialog;
  mutable QElapsedTimer m_since_events;
  mutable std::atomic<bool> m_cancelled{false};
};

/// The dialog; false if it was cancelled.
bool ask(QWidget* parent, bool has_features, Request& request) {
  QDialog dialog(parent);
  dialog.setWindowTitle("Quadrangulate (Reeb atlas)");
  auto* form = new QFormLayout(&dialog);
  auto* quads = new QSpinBox;
  quads->setRange(24, 10000000);
  quads->setValue(request.quads);
  form->addRow("About how many quads", quads);
  auto* effort = new QComboBox;
  effort->addItems({"fast", "default", "best"});
  effort->setCurrentText(request.effort);
  form->addRow("Effort", effort);
  auto* angle = new QDoubleSpinBox;
  angle->setRange(0, 180);
  angle->setValue(request.feature_angle);
  angle->setSpecialValueText("none");
  form->addRow("Keep edges sharper than (degrees)", angle);
  auto* features = new QCheckBox("instead: those detected on this item");
  features->setEnabled(has_features);
  form->addRow(QString(), features);
  auto* mirror = new QComboBox;
  mirror->addItems({"none", "auto", "x", "y", "z"});
  mirror->setCurrentText(request.mirror);
  form->addRow("Mirror", mirror);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) return false;
  request = {quads->value(), effort->currentText(), angle->value(), mirror->currentText(),
             features->isEnabled() && features->isChecked()};
  return true;
}

using Feature_map = SMesh::Property_map<SMesh::Edge_index, bool>;

/// The edges that the item has as its features, if it has some.
bool features_of(const SMesh& mesh, Feature_map& features) {
  const auto [map, exists] = mesh.property_map<SMesh::Edge_index, bool>("e:is_feature");
  if (!exists) return false;
  features = map;
  for (const SMesh::Edge_index e : mesh.edges())
    if (map[e]) return true;
  return false;
}

using Components = std::vector<RQ::Quadrangulation>;

/// Quads of all components, added to `quads`.
RQ::Result<Components> run(const SMesh& mesh, const Request& request,
                           const RQ::Quadrangulation_options& options, RQ::Observer& observer, SMesh& quads) {
  const auto asked = RQ::parameters::options(options).observer(&observer);
  if (!request.item_features) return RQ::quadrangulate_components(mesh, quads, asked);
  Feature_map features;
  if (!features_of(mesh, features))
    return RQ::make_error(RQ::Error_code::impossible_request, "no edge of the item is marked as a feature");
  return RQ::quadrangulate_components(mesh, quads, asked.edge_is_constrained_map(features));
}

/// Gives charts the colours that the demo has for patches. An item must exist before its mesh has patches:
/// the demo draws an item as it is made, when it has no colours for them yet.
void colour_charts(const Components& components, Scene_surface_mesh_item& item) {
  item.setItemIsMulticolor(true);
  item.computeItemColorVectorAutomatically(true); // without it the demo reads colours that there are not
  SMesh& quads = *item.face_graph();
  auto patches = quads.property_map<SMesh::Face_index, int>("f:patch_id").first;
  auto face = quads.faces().begin(); // faces are in the order of the components' quads
  int first = 0;
  for (const RQ::Quadrangulation& component : components) {
    int charts = 0; // every component counts its own from 0
    for (const int chart : component.chart_of_quad) {
      patches[*face++] = first + chart;
      charts = std::max(charts, chart + 1);
    }
    first += charts;
  }
  item.invalidateOpenGLBuffers();
}

/// Says in the demo's console what the certificate says.
void tell(const RQ::Certificate& certificate) {
  int extraordinary = 0;
  for (const auto& [valence, number] : certificate.interior_valences)
    if (valence != 4) extraordinary += number;
  const QString summary = QString("Certificate %1: %2 quads, extraordinary vertices: %3, components: %4")
                              .arg(certificate.passed ? "passed" : "FAILED")
                              .arg(certificate.quads)
                              .arg(extraordinary)
                              .arg(certificate.components.size());
  if (certificate.passed)
    Three::information(summary);
  else
    Three::error(summary);
  if (certificate.shape) Three::information(QString::fromStdString(RQ::shape_summary(*certificate.shape)));
  for (const RQ::Certificate_check& check : certificate.checks)
    if (check.status == RQ::Check_status::failed)
      Three::warning(QString::fromStdString(check.name + ": " + check.message));
  for (const RQ::Shape_warning& warning : certificate.warnings)
    Three::warning(QString::fromStdString(warning.text));
}

} // namespace

class Reeb_quadrangulation_plugin : public QObject, public CGAL::Three::Polyhedron_demo_plugin_interface {
  Q_OBJECT
  Q_INTERFACES(CGAL::Three::Polyhedron_demo_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.PolyhedronDemo.PluginInterface/1.0" FILE
                        "reeb_quadrangulation_plugin.json")

public:
  void init(QMainWindow* window, CGAL::Three::Scene_interface* scene, Messages_interface*) override {
    m_window = window;
    m_scene = scene;
    m_action = new QAction("Quadrangulate (Reeb atlas)", window);
    m_action->setObjectName("actionQuadrangulateReebAtlas");
    m_action->setProperty("subMenuName", "Polygon Mesh Processing");
    connect(m_action, &QAction::triggered, this, &Reeb_quadrangulation_plugin::ask_and_run);
  }

  bool applicable(QAction*) const override {
    const Scene_surface_mesh_item* item = selected();
    return item && !item->isEmpty() && CGAL::is_triangle_mesh(*item->face_graph());
  }

  QList<QAction*> actions() const override { return {m_action}; }

public Q_SLOTS:
  /// For the demo's scripts: what the dialog asks for, without it. Whether there are quads, in a new item.
  bool quadrangulate(int quads, const QString& effort, double feature_angle, const QString& mirror,
                     bool item_features) {
    return make_quads({quads, effort, feature_angle, mirror, item_features});
  }

private:
  Scene_surface_mesh_item* selected() const {
    return qobject_cast<Scene_surface_mesh_item*>(m_scene->item(m_scene->mainSelectionIndex()));
  }

  void ask_and_run() {
    const Scene_surface_mesh_item* item = selected();
    Feature_map features;
    if (item && ask(m_window, features_of(*item->face_graph(), features), m_request)) make_quads(m_request);
  }

  bool refuse(const QString& sentence) {
    Three::error("Quadrangulate (Reeb atlas): " + sentence);
    return false;
  }
  bool refuse(const RQ::Error& error) {
    const QString sentence = QString::fromStdString(error.message);
    if (error.code != RQ::Error_code::cancelled) return refuse(sentence);
    Three::information("Quadrangulate (Reeb atlas): " + sentence); // no error, for the user asked for it
    return false;
  }

  bool make_quads(const Request& request) {
    Scene_surface_mesh_item* item = selected();
    if (!item || !applicable(m_action)) return refuse("no triangle mesh is selected");
    RQ::Quadrangulation_options options;
    QString error;
    if (!read_options(request, options, error)) return refuse(error);
    const Three::CursorScopeGuard busy(Qt::BusyCursor);
    const SMesh& mesh = *item->face_graph();
    SMesh quads;
    Progress progress(m_window);
    const auto components = run(mesh, request, options, progress, quads);
    if (!components) return refuse(components.error());
    progress.progress("certificate", 1);
    RQ::Certificate_options measures;
    measures.observer = &progress;
    const auto certificate = RQ::certify(quads, mesh, RQ::parameters::options(measures));
    if (!certificate) return refuse(certificate.error());
    tell(*certificate);
    if (progress.cancelled()) Three::warning("The certificate was cancelled: not all of it is measured.");
    auto* quad_item = new Scene_surface_mesh_item(std::move(quads));
    quad_item->setName(item->name() + " (quads)");
    quad_item->setRenderingMode(FlatPlusEdges);
    colour_charts(*components, *quad_item);
    item->setVisible(false);
    m_scene->setSelectedItem(m_scene->addItem(quad_item));
    return true;
  }

  QMainWindow* m_window = nullptr;
  CGAL::Three::Scene_interface* m_scene = nullptr;
  QAction* m_action = nullptr;
  Request m_request;
};

#include "Reeb_quadrangulation_plugin.moc"
