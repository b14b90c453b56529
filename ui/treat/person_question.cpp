#include "treat/person_question.h"

#include <QMessageBox>
#include <QPushButton>

namespace facenav::ui {

void askForPerson(QWidget& parent, const QString& name, const QString& why, std::function<void()> confirmed) {
  auto* question = new QMessageBox(QMessageBox::Question, QObject::tr("FaceNav"),
                                   QObject::tr("Is this the patient of case %1?").arg(name),
                                   QMessageBox::NoButton, &parent);
  question->setObjectName("person_question");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setTextFormat(Qt::PlainText);
  question->setInformativeText(
      QObject::tr("%1\n\nAsk for name and date of birth. Say yes only if they are those "
                  "of this case: with another person's MRI the target would be wrong.")
          .arg(why));
  auto* no = question->addButton(QObject::tr("No, do not align"), QMessageBox::RejectRole);
  auto* yes = question->addButton(QObject::tr("Yes, checked: align"), QMessageBox::AcceptRole);
  question->setDefaultButton(no);
  question->setEscapeButton(no);
  QObject::connect(yes, &QAbstractButton::clicked, &parent, std::move(confirmed));
  question->open();
}

}  // namespace facenav::ui
