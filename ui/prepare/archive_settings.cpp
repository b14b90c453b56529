#include "prepare/archive_settings.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace facenav::ui {

ArchiveSettings::ArchiveSettings(ArchivePresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  auto* heading = new QLabel(tr("The archive"), this);
  heading->setObjectName("heading");
  column->addWidget(heading);
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  column->addLayout(form);
  const auto& node = presenter_.node();
  const auto tls = node.tls.value_or(pacs::Tls{});
  host_ = line(*form, tr("address"), node.host, tr("the archive's name or address in the network"));
  port_ = number(*form, tr("port"), node.port, 65535, tr("its DICOM port, often 104 or 11112"));
  title_ = line(*form, tr("its title"), node.title, tr("its application entity title"));
  own_title_ = line(*form, tr("our title"), node.own_title, tr("ours, as it is entered in the archive"));
  own_port_ = number(*form, tr("our port"), node.own_port, 65535,
                     tr("where the archive sends to when it retrieves by C-MOVE"));
  timeout_ = number(*form, tr("wait, s"), node.timeout_s, 600, tr("how long an answer is waited for"));
  retrieval_ = new QComboBox(this);
  retrieval_->addItems({tr("automatic"), tr("C-GET"), tr("C-MOVE")});
  retrieval_->setCurrentIndex(int(presenter_.retrieval()));
  retrieval_->setToolTip(
      tr("how series are fetched; automatic: C-GET, and C-MOVE where that is not offered"));
  form->addRow(tr("fetch by"), retrieval_);
  trusted_ = line(*form, tr("TLS trust"), tls.trusted_certificate.string(),
                  tr("PEM certificate of the archive, or of who signed it; empty: no TLS"));
  certificate_ =
      line(*form, tr("our certificate"), tls.certificate.string(), tr("PEM, where the archive asks for one"));
  key_ = line(*form, tr("our key"), tls.key.string(), tr("PEM, of our certificate"));
  test_ = new QPushButton(tr("Test"), this);
  test_->setToolTip(tr("is it there, and does it know us: C-ECHO (Ctrl+T)"));
  test_->setShortcut(Qt::CTRL + Qt::Key_T);
  column->addWidget(test_);
  column->addStretch(1);
  connect(test_, &QPushButton::clicked, &presenter_, &ArchivePresenter::test);
  connect(retrieval_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { presenter_.setRetrieval(pacs::Retrieval(index)); });
  connect(&presenter_, &ArchivePresenter::changed, this, [this] { test_->setEnabled(!presenter_.isBusy()); });
}

QLineEdit* ArchiveSettings::line(QFormLayout& form, const QString& name, const std::string& value,
                                 const QString& tip) {
  auto* made = new QLineEdit(QString::fromStdString(value), this);
  made->setToolTip(tip);
  made->setAccessibleName(name);
  form.addRow(name, made);
  connect(made, &QLineEdit::textEdited, this, &ArchiveSettings::take);
  return made;
}

QSpinBox* ArchiveSettings::number(QFormLayout& form, const QString& name, int value, int most,
                                  const QString& tip) {
  auto* made = new QSpinBox(this);
  made->setRange(1, most);
  made->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the arrow keys still work
  made->setValue(value);
  made->setToolTip(tip);
  made->setAccessibleName(name);
  form.addRow(name, made);
  connect(made, QOverload<int>::of(&QSpinBox::valueChanged), this, &ArchiveSettings::take);
  return made;
}

/// Called at every keystroke, so that a shortcut (Test, Find, Fetch) uses what the fields show.
void ArchiveSettings::take() {
  pacs::PacsNode node;
  node.host = host_->text().trimmed().toStdString();
  node.port = port_->value();
  node.title = title_->text().trimmed().toStdString();
  node.own_title = own_title_->text().trimmed().toStdString();
  node.own_port = own_port_->value();
  node.timeout_s = timeout_->value();
  if (!trusted_->text().trimmed().isEmpty())
    node.tls = pacs::Tls{trusted_->text().trimmed().toStdString(),
                         certificate_->text().trimmed().toStdString(), key_->text().trimmed().toStdString()};
  presenter_.setNode(node);
}

}  // namespace facenav::ui
