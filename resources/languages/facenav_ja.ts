<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja">
<context>
    <name></name>
    <message>
        <source>%1 came in (Ctrl+Z in Plan takes them back)</source>
        <translation>%1を取り込みました (計画の画面で Ctrl+Z を押すと取り消せます)</translation>
    </message>
    <message>
        <source>1 target</source>
        <translation>標的 1 個</translation>
    </message>
    <message>
        <source>%1 targets</source>
        <translation>標的 %1 個</translation>
    </message>
    <message>
        <source>session of %1</source>
        <translation>%1 のセッション</translation>
    </message>
    <message>
        <source> with %1</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>1 pulse</source>
        <translation>パルス 1 回</translation>
    </message>
    <message>
        <source>%1 pulses</source>
        <translation>パルス %1 回</translation>
    </message>
</context>
<context>
    <name>QComboBox</name>
    <message>
        <source>no camera found: type an address</source>
        <translation>カメラが見つかりません: アドレスを入力してください</translation>
    </message>
    <message>
        <source>choose one, or type an address</source>
        <translation>1 つ選ぶか、アドレスを入力してください</translation>
    </message>
    <message>
        <source>no camera found</source>
        <translation>カメラが見つかりません</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>FaceNav (changed settings)</source>
        <translation>FaceNav (設定変更あり)</translation>
    </message>
    <message>
        <source>choose RAS or LPS under Coordinates</source>
        <translation>「座標」で RAS か LPS を選んでください</translation>
    </message>
    <message>
        <source>choose sform or qform under Form</source>
        <translation>「変換」で sform か qform を選んでください</translation>
    </message>
    <message>
        <source>under Form</source>
        <translation>「変換」で</translation>
    </message>
    <message>
        <source>choose one under Handle</source>
        <translation>「ハンドル」で 1 つ選んでください</translation>
    </message>
    <message>
        <source>choose one under Head frame</source>
        <translation>「頭部座標系」で 1 つ選んでください</translation>
    </message>
    <message>
        <source>choose \1 T1 under T1</source>
        <translation>「T1」で \1 T1 を選んでください</translation>
    </message>
    <message>
        <source>tick Replace, or rename it</source>
        <translation>「置き換える」にチェックを入れるか、名前を変えてください</translation>
    </message>
    <message>
        <source>, or tick Replace</source>
        <translation>、または「置き換える」にチェックを入れてください</translation>
    </message>
    <message>
        <source>tick one target</source>
        <translation>標的 1 つにチェックを入れてください</translation>
    </message>
    <message>
        <source>; with a session: \1</source>
        <translation>; セッションを選んだとき: \1</translation>
    </message>
    <message>
        <source>type its coordinates in Plan for a target there</source>
        <translation>そこに標的を作るには、計画の画面で座標を入力してください</translation>
    </message>
    <message>
        <source>target</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>ランドマーク</translation>
    </message>
    <message>
        <source>electrode</source>
        <translation>電極</translation>
    </message>
    <message>
        <source>comes in</source>
        <translation>取り込む</translation>
    </message>
    <message>
        <source>replaces the one here</source>
        <translation>既存のものを置き換える</translation>
    </message>
    <message>
        <source>is here already</source>
        <translation>既にある</translation>
    </message>
    <message>
        <source>is shown only</source>
        <translation>表示のみ</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>取り込み不可</translation>
    </message>
    <message>
        <source>stays out</source>
        <translation>取り込まない</translation>
    </message>
    <message>
        <source>Coordinates: %1, as chosen here</source>
        <translation>座標: %1 (ここで選択)</translation>
    </message>
    <message>
        <source>Coordinates: the file does not say</source>
        <translation>座標: ファイルに指定なし</translation>
    </message>
    <message>
        <source>Coordinates: %1, as the file says</source>
        <translation>座標: %1 (ファイルの指定)</translation>
    </message>
    <message>
        <source>the case&apos;s own</source>
        <translation>症例の T1</translation>
    </message>
    <message>
        <source>; by nasion and ears, without a T1</source>
        <translation>; 鼻根点と両耳による、T1 なし</translation>
    </message>
    <message>
        <source>; T1: %1, by its %2</source>
        <translation>; T1: %1、その %2 による</translation>
    </message>
    <message>
        <source>; T1: %1, by its %2 as chosen here</source>
        <translation>; T1: %1、その %2 による (ここで選択)</translation>
    </message>
    <message>
        <source>; T1: %1, by its %2 as the file says</source>
        <translation>; T1: %1、その %2 による (ファイルの指定)</translation>
    </message>
    <message>
        <source>%1 pulses, ±%2 mm, ±%3°</source>
        <translation>パルス %1 回、±%2 mm、±%3°</translation>
    </message>
    <message>
        <source>Return error: coil&apos;s centre</source>
        <translation>再現誤差: コイル中心</translation>
    </message>
    <message>
        <source>Return error: tilt</source>
        <translation>再現誤差: 傾き</translation>
    </message>
    <message>
        <source>Return error: handle turned</source>
        <translation>再現誤差: ハンドルの回転</translation>
    </message>
    <message>
        <source>Return error: whole rotation</source>
        <translation>再現誤差: 回転全体</translation>
    </message>
    <message>
        <source>Pulses of the other session</source>
        <translation>比較相手のセッションのパルス</translation>
    </message>
    <message>
        <source>Pulses of the chosen session</source>
        <translation>選択したセッションのパルス</translation>
    </message>
    <message>
        <source>The target itself moved between them</source>
        <translation>両者の間での標的自体の移動</translation>
    </message>
    <message>
        <source>Median MEP</source>
        <translation>MEP の中央値</translation>
    </message>
    <message>
        <source>MEP map (sigma %1 mm): peak %2 uV at %3, centre of gravity %4 (RAS mm), area at %5 uV or more %6 mm², %7 of %8 pulses responded</source>
        <translation>MEP マップ (sigma %1 mm): 最大 %2 uV、位置 %3、重心 %4 (RAS mm)、%5 uV 以上の面積 %6 mm²、%8 パルス中 %7 で反応あり</translation>
    </message>
    <message>
        <source>Built for %1 by %2, with Qt %3</source>
        <translation>%1 用、%2 でビルド、Qt %3</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>バージョン %1</translation>
    </message>
    <message>
        <source>Licence: &lt;a href=&apos;LICENSE.md&apos;&gt;Apache-2.0&lt;/a&gt;. Not a medical device: for research and development. &lt;a href=&apos;safety.md&apos;&gt;Safety&lt;/a&gt;, &lt;a href=&apos;privacy.md&apos;&gt;privacy&lt;/a&gt;.</source>
        <translation>ライセンス: &lt;a href=&apos;LICENSE.md&apos;&gt;Apache-2.0&lt;/a&gt;。医療機器ではありません: 研究開発用です。&lt;a href=&apos;safety.md&apos;&gt;安全&lt;/a&gt;、&lt;a href=&apos;privacy.md&apos;&gt;プライバシー&lt;/a&gt;。</translation>
    </message>
    <message>
        <source>Parts that others made</source>
        <translation>第三者による構成部品</translation>
    </message>
    <message>
        <source>&apos;facenav licences --spdx&apos; writes this list as a bill of materials.</source>
        <translation>&apos;facenav licences --spdx&apos; はこの一覧を部品表として書き出します。</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>%1/%2 ページ</translation>
    </message>
    <message>
        <source>Keep the picture (it may show a patient)</source>
        <translation>画像を保存 (患者が写っている可能性があります)</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>picture kept: %1</source>
        <translation>画像を保存しました: %1</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>共通</translation>
    </message>
    <message>
        <source>see the tooltips of this page</source>
        <translation>この画面のツールチップを参照してください</translation>
    </message>
    <message>
        <source>The picture was not kept</source>
        <translation>画像は保存されませんでした</translation>
    </message>
    <message>
        <source>Copy the coordinates %1 (RAS, mm)</source>
        <translation>座標 %1 をコピー (RAS、mm)</translation>
    </message>
    <message>
        <source>Go to this place</source>
        <translation>この場所へ移動</translation>
    </message>
    <message>
        <source>Reset the view</source>
        <translation>表示を初期状態に戻す</translation>
    </message>
    <message>
        <source>Save a picture of the view…</source>
        <translation>表示の画像を保存…</translation>
    </message>
    <message>
        <source>take the picture with dots first</source>
        <translation>先にドットありの画像を撮影してください</translation>
    </message>
    <message>
        <source>no new picture from the cameras yet: take it again</source>
        <translation>カメラから新しい画像がまだ来ません: 撮影し直してください</translation>
    </message>
    <message>
        <source>more than %1 s between the two pictures: take both again</source>
        <translation>2 枚の撮影間隔が %1 s を超えています: 両方とも撮影し直してください</translation>
    </message>
    <message>
        <source>taken: align now, the head as it is</source>
        <translation>撮影しました: 頭をそのままにして、位置合わせを行ってください</translation>
    </message>
    <message>
        <source>now the projector off, the head still, and take the second picture</source>
        <translation>次にプロジェクターを消し、頭を動かさずに 2 枚目を撮影してください</translation>
    </message>
    <message>
        <source>look at the cameras, and hold the coil still beside the face, its marker to both cameras: the picture is taken by itself</source>
        <translation>カメラを見て、コイルを顔の横に静止させ、マーカーを両方のカメラに向けてください: 自動で撮影します</translation>
    </message>
</context>
<context>
    <name>SecondCoilChoice</name>
    <message>
        <source>two coils are followed: say which one gives the pulses (tool Session)</source>
        <translation>2 つのコイルを追跡します: どちらが照射するかを指定してください (「セッション」ツール)</translation>
    </message>
</context>
<context>
    <name>facenav::ui</name>
    <message>
        <source>three numbers in mm are expected, such as -38 -22 56</source>
        <translation>mm の数値 3 つを入力してください。例: -38 -22 56</translation>
    </message>
    <message>
        <source>a comma here could be a decimal mark or part two numbers: type 12.5; -3; 40</source>
        <translation>このコンマは小数点とも区切りとも取れます: 12.5; -3; 40 のように入力してください</translation>
    </message>
    <message>
        <source>gap %1 mm, field −%2 %</source>
        <translation>隙間 %1 mm、電場 −%2 %</translation>
    </message>
    <message>
        <source>contact face&apos;s centre above the MRI&apos;s skin, by the poses of head and coil; the field is lost against a coil that touches the skin</source>
        <translation>頭とコイルの姿勢による、MRI の皮膚から接触面の中心までの高さ。電場の低下は、皮膚に接するコイルと比べた値です</translation>
    </message>
    <message>
        <source>; seen %1 mm</source>
        <translation>; 実測 %1 mm</translation>
    </message>
    <message>
        <source>; seen: above the surface (skin or hair) that both cameras measure beside the coil</source>
        <translation>; 実測: 両方のカメラがコイルの横で計測した表面 (皮膚または髪) からの高さ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: tracked, no target</source>
        <translation>%1: 追跡中、標的なし</translation>
    </message>
    <message>
        <source>%1: tracked</source>
        <translation>%1: 追跡中</translation>
    </message>
    <message>
        <source>%1: %2, across %3, depth %4 mm, tilt %5</source>
        <translation>%1: %2、横ずれ %3、深さ %4 mm、傾き %5</translation>
    </message>
    <message>
        <source>on target</source>
        <translation>標的上</translation>
    </message>
    <message>
        <source>adjust</source>
        <translation>要調整</translation>
    </message>
    <message>
        <source>CAMERAS on</source>
        <translation>カメラ 動作中</translation>
    </message>
    <message>
        <source>CAMERAS no images</source>
        <translation>カメラ 画像なし</translation>
    </message>
    <message>
        <source>CAMERAS %1 ms apart</source>
        <translation>カメラ 時間差 %1 ms</translation>
    </message>
    <message>
        <source>one camera exposes later than the other; the head&apos;s motion in between is allowed for, but a trigger for both is better</source>
        <translation>一方のカメラの露光が遅れています。その間の頭の動きは補正しますが、両方に共通のトリガーを使うほうが確実です</translation>
    </message>
    <message>
        <source>FACE</source>
        <translation>顔</translation>
    </message>
    <message>
        <source>COIL</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>%1 ms   %2 dropped</source>
        <translation>%1 ms   欠落 %2</translation>
    </message>
    <message>
        <source>95 % within %1 mm at the target</source>
        <translation>標的で 95 % が %1 mm 以内</translation>
    </message>
    <message>
        <source>ON TARGET: %1</source>
        <translation>標的上: %1</translation>
    </message>
    <message>
        <source>ADJUST: %1</source>
        <translation>要調整: %1</translation>
    </message>
    <message>
        <source>choose a target</source>
        <translation>標的を選んでください</translation>
    </message>
    <message>
        <source>%1: %2 frames, %3 per s%4</source>
        <translation>%1: %2 フレーム、毎秒 %3%4</translation>
    </message>
    <message>
        <source> (assumed)</source>
        <translation> (推定)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ArchivePage</name>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>検査</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>シリーズ</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>画像数</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>患者</translation>
    </message>
    <message>
        <source>series in the archive</source>
        <translation>アーカイブ内のシリーズ</translation>
    </message>
    <message>
        <source>double click: fetch</source>
        <translation>ダブルクリック: 取得</translation>
    </message>
    <message>
        <source>patient ID</source>
        <translation>患者 ID</translation>
    </message>
    <message>
        <source>* and ? stand for anything</source>
        <translation>* と ? は任意の文字を表します</translation>
    </message>
    <message>
        <source>name</source>
        <translation>氏名</translation>
    </message>
    <message>
        <source>FAMILY^GIVEN as the archive writes it; * and ? stand for anything</source>
        <translation>アーカイブの表記どおりの 姓^名。* と ? は任意の文字を表します</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>YYYYMMDD, or from-to: YYYYMMDD-YYYYMMDD</source>
        <translation>YYYYMMDD、または期間: YYYYMMDD-YYYYMMDD</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>MR</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>any kind</source>
        <translation>すべての種類</translation>
    </message>
    <message>
        <source>kind of image</source>
        <translation>画像の種類</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>ask the archive (Return in a field)</source>
        <translation>アーカイブに問い合わせます (入力欄で Return)</translation>
    </message>
    <message>
        <source>Fetch and prepare</source>
        <translation>取得して準備</translation>
    </message>
    <message>
        <source>bring the chosen series here and queue it (Ctrl+Return)</source>
        <translation>選んだシリーズを取得し、待ち行列に入れます (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>stop; nothing half-fetched is kept</source>
        <translation>中止します。取得途中のものは残りません</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>to the series page (Alt+2)</source>
        <translation>シリーズの画面へ (Alt+2)</translation>
    </message>
    <message>
        <source>show patients</source>
        <translation>患者を表示</translation>
    </message>
    <message>
        <source>patient ID and name in the list; hidden otherwise</source>
        <translation>一覧に患者 ID と氏名を表示します。それ以外は隠します</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ArchivePresenter</name>
    <message>
        <source>%1: %2 %3 %</source>
        <translation>%1: %2 %3 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: cancelled, nothing was kept</source>
        <translation>%1: キャンセルしました。何も保存されていません</translation>
    </message>
    <message>
        <source>Calling the archive</source>
        <translation>アーカイブに接続しています</translation>
    </message>
    <message>
        <source>✓ the archive answers and knows us</source>
        <translation>✓ アーカイブが応答し、この装置を認識しました</translation>
    </message>
    <message>
        <source>Asking the archive</source>
        <translation>アーカイブに問い合わせています</translation>
    </message>
    <message>
        <source>nothing in the archive matches</source>
        <translation>該当するものがアーカイブにありません</translation>
    </message>
    <message>
        <source>series found: %1</source>
        <translation>見つかったシリーズ: %1</translation>
    </message>
    <message>
        <source>Fetching</source>
        <translation>取得しています</translation>
    </message>
    <message>
        <source>✓ %1 images fetched: in the worklist&apos;s queue</source>
        <translation>✓ 画像 %1 枚を取得しました: ワークリストの待ち行列に入りました</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ArchiveSettings</name>
    <message>
        <source>The archive</source>
        <translation>アーカイブ</translation>
    </message>
    <message>
        <source>address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>the archive&apos;s name or address in the network</source>
        <translation>ネットワーク上のアーカイブの名前またはアドレス</translation>
    </message>
    <message>
        <source>port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>its DICOM port, often 104 or 11112</source>
        <translation>アーカイブの DICOM ポート。多くは 104 または 11112</translation>
    </message>
    <message>
        <source>its title</source>
        <translation>アーカイブの AE タイトル</translation>
    </message>
    <message>
        <source>its application entity title</source>
        <translation>アーカイブのアプリケーションエンティティ (AE) タイトル</translation>
    </message>
    <message>
        <source>our title</source>
        <translation>自分の AE タイトル</translation>
    </message>
    <message>
        <source>ours, as it is entered in the archive</source>
        <translation>アーカイブに登録されている、この装置の AE タイトル</translation>
    </message>
    <message>
        <source>our port</source>
        <translation>自分のポート</translation>
    </message>
    <message>
        <source>where the archive sends to when it retrieves by C-MOVE</source>
        <translation>C-MOVE で取得するときにアーカイブが送信する先のポート</translation>
    </message>
    <message>
        <source>wait, s</source>
        <translation>待ち時間 (s)</translation>
    </message>
    <message>
        <source>how long an answer is waited for</source>
        <translation>応答を待つ時間</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>C-GET</source>
        <translation>C-GET</translation>
    </message>
    <message>
        <source>C-MOVE</source>
        <translation>C-MOVE</translation>
    </message>
    <message>
        <source>how series are fetched; automatic: C-GET, and C-MOVE where that is not offered</source>
        <translation>シリーズの取得方法。自動: C-GET を使い、対応していなければ C-MOVE を使います</translation>
    </message>
    <message>
        <source>fetch by</source>
        <translation>取得方法</translation>
    </message>
    <message>
        <source>TLS trust</source>
        <translation>TLS の信頼</translation>
    </message>
    <message>
        <source>PEM certificate of the archive, or of who signed it; empty: no TLS</source>
        <translation>アーカイブの、またはその署名者の PEM 証明書。空欄: TLS を使いません</translation>
    </message>
    <message>
        <source>our certificate</source>
        <translation>自分の証明書</translation>
    </message>
    <message>
        <source>PEM, where the archive asks for one</source>
        <translation>PEM 形式。アーカイブが証明書を求める場合に使います</translation>
    </message>
    <message>
        <source>our key</source>
        <translation>自分の秘密鍵</translation>
    </message>
    <message>
        <source>PEM, of our certificate</source>
        <translation>PEM 形式。自分の証明書の秘密鍵</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>テスト</translation>
    </message>
    <message>
        <source>is it there, and does it know us: C-ECHO (Ctrl+T)</source>
        <translation>アーカイブが応答し、この装置を認識するか: C-ECHO (Ctrl+T)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::BestPosePresenter</name>
    <message>
        <source>turned %1° clockwise</source>
        <translation>時計回りに %1° 回転</translation>
    </message>
    <message>
        <source>turned %1° anticlockwise</source>
        <translation>反時計回りに %1° 回転</translation>
    </message>
    <message>
        <source>%1 mm forwards</source>
        <translation>コイルの前方へ %1 mm</translation>
    </message>
    <message>
        <source>%1 mm backwards</source>
        <translation>コイルの後方へ %1 mm</translation>
    </message>
    <message>
        <source>%1 mm to the left</source>
        <translation>コイルの左側へ %1 mm</translation>
    </message>
    <message>
        <source>%1 mm to the right</source>
        <translation>コイルの右側へ %1 mm</translation>
    </message>
    <message>
        <source>less than 1 mm away</source>
        <translation>ずれは 1 mm 未満</translation>
    </message>
    <message>
        <source>Best pose</source>
        <translation>最良の姿勢</translation>
    </message>
    <message>
        <source>searching 36 angles at 25 places …</source>
        <translation>25 か所で 36 通りの角度を探索しています …</translation>
    </message>
    <message>
        <source>the planned pose is the best one: %1 V/m</source>
        <translation>計画した姿勢が最良です: %1 V/m</translation>
    </message>
    <message>
        <source>%1: %2 V/m in place of %3; %4</source>
        <translation>%1: %3 V/m に対し %2 V/m; %4</translation>
    </message>
</context>
<context>
    <name>facenav::ui::BoardScreen</name>
    <message>
        <source>FaceNav: calibration board</source>
        <translation>FaceNav: 較正ボード</translation>
    </message>
    <message>
        <source>measure one square with a ruler and type it in; Escape closes this</source>
        <translation>1 マスを定規で測って入力してください。Escape で閉じます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::BrainLookPanel</name>
    <message>
        <source>φ–θ model</source>
        <translation>φ–θ モデル</translation>
    </message>
    <message>
        <source>Cortex</source>
        <translation>皮質</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>並べて表示</translation>
    </message>
    <message>
        <source>the brain as the phi-theta model draws it (Shift+1)</source>
        <translation>φ–θ モデルが描く脳 (Shift+1)</translation>
    </message>
    <message>
        <source>the true surface, both banks of every sulcus, with the MRI at the peel depth (Shift+2)</source>
        <translation>実際の表面 (すべての脳溝の両壁) と、表示深さでの MRI (Shift+2)</translation>
    </message>
    <message>
        <source>the true surface, coloured by its distance from the phi-theta model (Shift+3)</source>
        <translation>実際の表面。φ–θ モデルからの距離で色付け (Shift+3)</translation>
    </message>
    <message>
        <source>the phi-theta model and, beside it, its distance from the true surface (Shift+4)</source>
        <translation>φ–θ モデルと、その横に実際の表面からの距離 (Shift+4)</translation>
    </message>
    <message>
        <source>peel depth</source>
        <translation>表示深さ</translation>
    </message>
    <message>
        <source>how deep below the surface the MRI is shown, 0 to 40 mm (arrows, Page up and down)</source>
        <translation>MRI を表面からどの深さで示すか、0〜40 mm (矢印キー、Page Up / Page Down)</translation>
    </message>
    <message>
        <source>of the distances between the phi-theta model and the true surface, all vertices</source>
        <translation>φ–θ モデルと実際の表面の距離について。すべての頂点が対象です</translation>
    </message>
    <message>
        <source>peel %1 mm</source>
        <translation>深さ %1 mm</translation>
    </message>
</context>
<context>
    <name>facenav::ui::BullsEyeView</name>
    <message>
        <source>Centre: the target. Cross: the coil, seen along the coil into the head, handle below. Stroke: tilt, one ring is 5 mm or 5°. Tick on the rim: twist.</source>
        <translation>中心: 標的。十字: コイル (コイルの軸に沿って頭の中へ向かって見た図。ハンドルは下)。線: 傾き。輪 1 つは 5 mm または 5°。縁の目盛り: ねじれ。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CameraFields</name>
    <message>
        <source>; or type an address: rtsp://.., /dev/video2, a video, a folder of pictures</source>
        <translation>; またはアドレスを入力してください: rtsp://..、/dev/video2、動画、画像のフォルダー</translation>
    </message>
    <message>
        <source>Left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>the camera on the left, seen from behind the pair, facing the patient</source>
        <translation>カメラペアの後ろから患者に向かって見て左側のカメラ</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>the camera on the right, seen from behind the pair, facing the patient</source>
        <translation>カメラペアの後ろから患者に向かって見て右側のカメラ</translation>
    </message>
    <message>
        <source>Size of the pictures</source>
        <translation>画像サイズ</translation>
    </message>
    <message>
        <source>width x height, px; both cameras must have it</source>
        <translation>幅 x 高さ (px)。両方のカメラで同じでなければなりません</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CameraRow</name>
    <message>
        <source>left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>The picture comes too late and is not shown. This computer draws too slowly: close other programs.</source>
        <translation>画像の到着が遅すぎるため表示していません。このコンピューターの描画が遅すぎます: ほかのプログラムを閉じてください。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CamerasPanel</name>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Or a recording</source>
        <translation>または記録を使う</translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>a folder with stereo.yml, played as if live</source>
        <translation>stereo.yml のあるフォルダー。ライブのように再生します</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>the camera on the left as seen from behind the pair, facing the patient</source>
        <translation>カメラペアの後ろから患者に向かって見て左側のカメラ</translation>
    </message>
    <message>
        <source>the camera on the right as seen from behind the pair, facing the patient</source>
        <translation>カメラペアの後ろから患者に向かって見て右側のカメラ</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>再検索</translation>
    </message>
    <message>
        <source>which cameras are plugged in</source>
        <translation>接続されているカメラを調べます</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>left for right</source>
        <translation>左と右を入れ替えます</translation>
    </message>
    <message>
        <source>Calibration…</source>
        <translation>較正…</translation>
    </message>
    <message>
        <source>the stereo.yml of these two cameras</source>
        <translation>この 2 台のカメラの stereo.yml</translation>
    </message>
    <message>
        <source>Open the cameras</source>
        <translation>カメラを開く</translation>
    </message>
    <message>
        <source>live pictures</source>
        <translation>ライブ画像</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>cameras, settings and calibration kept under a name (facenav rig new)</source>
        <translation>名前を付けて保存したカメラ、設定、較正 (facenav rig new)</translation>
    </message>
    <message>
        <source>rig</source>
        <translation>カメラ構成</translation>
    </message>
    <message>
        <source>Set up the cameras…</source>
        <translation>カメラの設定…</translation>
    </message>
    <message>
        <source>place, calibrate and check a pair in four steps</source>
        <translation>カメラペアを 4 段階で設置、較正、点検します</translation>
    </message>
    <message>
        <source>Measure the delay…</source>
        <translation>遅延を測る…</translation>
    </message>
    <message>
        <source>from the left camera to the screen: it films a flashing field</source>
        <translation>左カメラから画面までの遅延。点滅する領域をカメラで撮影します</translation>
    </message>
    <message>
        <source>Picture for the alignment</source>
        <translation>位置合わせ用の画像</translation>
    </message>
    <message>
        <source>Take the picture</source>
        <translation>撮影</translation>
    </message>
    <message>
        <source>the face with the coil&apos;s marker beside it; no projector is needed</source>
        <translation>顔とその横のコイルのマーカーを撮影します。プロジェクターは不要です</translation>
    </message>
    <message>
        <source>1 With dots</source>
        <translation>1 ドットあり</translation>
    </message>
    <message>
        <source>the face with the projector on</source>
        <translation>プロジェクターを点けて撮影した顔</translation>
    </message>
    <message>
        <source>2 Without dots</source>
        <translation>2 ドットなし</translation>
    </message>
    <message>
        <source>the face as it was, the projector off</source>
        <translation>同じ位置の顔。プロジェクターは消します</translation>
    </message>
    <message>
        <source>or with a projector</source>
        <translation>またはプロジェクターを使う</translation>
    </message>
    <message>
        <source>none kept under a name</source>
        <translation>名前を付けて保存したものはありません</translation>
    </message>
    <message>
        <source>chosen one by one</source>
        <translation>個別に選択</translation>
    </message>
    <message>
        <source>Coil: %1</source>
        <translation>コイル: %1</translation>
    </message>
    <message>
        <source>Check and repair the cameras…</source>
        <translation>カメラの点検と修復…</translation>
    </message>
    <message>
        <source>Check the cameras…</source>
        <translation>カメラの点検…</translation>
    </message>
    <message>
        <source>Open the cameras again</source>
        <translation>カメラを開き直す</translation>
    </message>
    <message>
        <source>after the cameras are repaired</source>
        <translation>カメラの修復後に開き直します</translation>
    </message>
    <message>
        <source>with live cameras: the face, and the coil&apos;s marker beside it</source>
        <translation>ライブカメラの場合: 顔と、その横のコイルのマーカー</translation>
    </message>
    <message>
        <source>Calibration of the cameras</source>
        <translation>カメラの較正</translation>
    </message>
    <message>
        <source>Calibration (*.yml *.yaml)</source>
        <translation>較正 (*.yml *.yaml)</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>記録を開く</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CamerasPresenter</name>
    <message>
        <source>the cameras are compared with what was kept: look at them, and hold the coil still</source>
        <translation>保存時の状態とカメラを比較しています: カメラを見て、コイルを静止させてください</translation>
    </message>
    <message>
        <source>other cameras or another calibration are chosen now: open the cameras again (step 1)</source>
        <translation>別のカメラまたは別の較正が選ばれています: カメラを開き直してください (手順 1)</translation>
    </message>
    <message>
        <source>Opening the cameras</source>
        <translation>カメラを開いています</translation>
    </message>
    <message>
        <source>recording, at its end</source>
        <translation>記録の終わり</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>NO PICTURE from the cameras</source>
        <translation>カメラの画像がありません</translation>
    </message>
    <message>
        <source>live, %1 pictures a second</source>
        <translation>ライブ、毎秒 %1 枚</translation>
    </message>
    <message>
        <source>no fresh picture from the cameras: nothing was taken</source>
        <translation>カメラから新しい画像が来ません: 撮影していません</translation>
    </message>
    <message>
        <source>Taking the picture</source>
        <translation>撮影しています</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CaseModel</name>
    <message>
        <source>scan rejected %1 by %2: %3</source>
        <translation>%1 に %2 がスキャンを却下: %3</translation>
    </message>
    <message>
        <source>a correction of the brain is not saved</source>
        <translation>脳の修正が保存されていません</translation>
    </message>
    <message>
        <source>not signed off, %1</source>
        <translation>未承認、%1</translation>
    </message>
    <message>
        <source>not signed off</source>
        <translation>未承認</translation>
    </message>
    <message>
        <source>checked %1 by %2</source>
        <translation>%1 に %2 が確認済み</translation>
    </message>
    <message>
        <source>sign-off of %1 void: %2</source>
        <translation>%1 の承認は無効: %2</translation>
    </message>
    <message>
        <source>sign-off of %1 void: %2 changed</source>
        <translation>%1 の承認は無効: %2 が変更されました</translation>
    </message>
</context>
<context>
    <name>facenav::ui::Change</name>
    <message>
        <source>a number is expected</source>
        <translation>数値を入力してください</translation>
    </message>
    <message>
        <source>that is no number</source>
        <translation>数値ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not taken: %2</source>
        <translation>&apos;%1&apos; は受け付けられません: %2</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CheckPage</name>
    <message>
        <source>Findings</source>
        <translation>所見</translation>
    </message>
    <message>
        <source>findings</source>
        <translation>所見</translation>
    </message>
    <message>
        <source>underlined findings go to their place (click, or Return)</source>
        <translation>下線付きの所見はその場所へ移動します (クリックまたは Return)</translation>
    </message>
    <message>
        <source>mask contours</source>
        <translation>マスクの輪郭</translation>
    </message>
    <message>
        <source>skin orange, brain blue (M)</source>
        <translation>皮膚はオレンジ、脳は青 (M)</translation>
    </message>
    <message>
        <source>Looks right: sign off</source>
        <translation>問題なし: 承認へ</translation>
    </message>
    <message>
        <source>on to step 4 (Ctrl+Return)</source>
        <translation>手順 4 へ進みます (Ctrl+Return)</translation>
    </message>
    <message>
        <source>!  </source>
        <translation>!  </translation>
    </message>
    <message>
        <source>✓  </source>
        <translation>✓  </translation>
    </message>
    <message>
        <source>go to this place</source>
        <translation>この場所へ移動</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CheckPresenter</name>
    <message>
        <source>Measuring the face for %1 s: the patient holds still</source>
        <translation>%1 秒間、顔を計測しています: 患者は動かないでください</translation>
    </message>
    <message>
        <source>Registration not checked: no measurement came</source>
        <translation>位置合わせは未確認: 計測値が得られませんでした</translation>
    </message>
    <message>
        <source>CHECK THE REGISTRATION: the last time was over %1 min ago</source>
        <translation>位置合わせを確認してください: 前回から %1 分以上経っています</translation>
    </message>
    <message>
        <source>Registration: as aligned, not checked since</source>
        <translation>位置合わせ: 実施時のまま、その後は未確認</translation>
    </message>
    <message>
        <source>Registration not checked: too little of the face seen</source>
        <translation>位置合わせは未確認: 顔の見える範囲が足りません</translation>
    </message>
    <message>
        <source>%1 mm, %2° off</source>
        <translation>ずれ %1 mm、%2°</translation>
    </message>
    <message>
        <source>REGISTRATION FAILED: %1; align again</source>
        <translation>位置合わせ不合格: %1; 位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>Registration passed: %1, %2 measurements</source>
        <translation>位置合わせ合格: %1、計測 %2 回</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CheckRow</name>
    <message>
        <source>Check</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>measures for two seconds whether the MRI still lies on the face; the patient holds still (K)</source>
        <translation>MRI が今も顔に合っているかを 2 秒間計測します。患者は動かないでください (K)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ChosenCameras</name>
    <message>
        <source>Looking for cameras</source>
        <translation>カメラを探しています</translation>
    </message>
    <message>
        <source>there is no rig called %1</source>
        <translation>%1 というカメラ構成はありません</translation>
    </message>
    <message>
        <source>never checked since it was made: check it (Set up)</source>
        <translation>作成後に一度も点検していません: 点検してください (カメラの設定)</translation>
    </message>
    <message>
        <source>last check: %1</source>
        <translation>前回の点検: %1</translation>
    </message>
    <message>
        <source> (%1); check it again today (Set up)</source>
        <translation> (%1); 今日もう一度点検してください (カメラの設定)</translation>
    </message>
    <message>
        <source>no calibration yet: set up the cameras, or choose the stereo.yml of these two cameras</source>
        <translation>まだ較正がありません: カメラを設定するか、この 2 台のカメラの stereo.yml を選んでください</translation>
    </message>
    <message>
        <source>%1 x %2 px, %3 mm apart</source>
        <translation>%1 x %2 px、間隔 %3 mm</translation>
    </message>
    <message>
        <source>, %1 px rms</source>
        <translation>、%1 px rms</translation>
    </message>
    <message>
        <source>, of %1</source>
        <translation>、%1 付</translation>
    </message>
    <message>
        <source>no camera found: plug two cameras in and look again, or open a recording</source>
        <translation>カメラが見つかりません: カメラを 2 台接続して再検索するか、記録を開いてください</translation>
    </message>
    <message>
        <source>choose two different cameras</source>
        <translation>別々の 2 台のカメラを選んでください</translation>
    </message>
    <message>
        <source>choose the calibration of these two cameras</source>
        <translation>この 2 台のカメラの較正を選んでください</translation>
    </message>
    <message>
        <source>ready to be opened</source>
        <translation>開く準備ができました</translation>
    </message>
    <message>
        <source>ready to be opened; %1</source>
        <translation>開く準備ができました; %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CoilSliceView</name>
    <message>
        <source>the MRI along the coil&apos;s axis and its handle, which is on the left; a tick is 10 mm; ring and lines beside the beam: 95 % of the errors at the target are smaller</source>
        <translation>コイルの軸とハンドルに沿った MRI (ハンドルは左側)。目盛りは 10 mm。ビーム横の輪と線: 標的での誤差の 95 % がこれより小さいことを示します</translation>
    </message>
    <message>
        <source>the MRI along the coil&apos;s axis and across its handle, as seen by the one who holds it; a tick is 10 mm; ring and lines beside the beam: 95 % of the errors at the target are smaller</source>
        <translation>コイルの軸に沿い、ハンドルを横切る MRI (コイルを持つ人から見た向き)。目盛りは 10 mm。ビーム横の輪と線: 標的での誤差の 95 % がこれより小さいことを示します</translation>
    </message>
    <message>
        <source>along the handle</source>
        <translation>ハンドル方向</translation>
    </message>
    <message>
        <source>across the handle</source>
        <translation>ハンドル横断方向</translation>
    </message>
    <message>
        <source>along: cortex %1 mm below the scalp</source>
        <translation>ハンドル方向: 皮質は頭皮下 %1 mm</translation>
    </message>
    <message>
        <source>across: beam %1 mm off</source>
        <translation>横断方向: ビームのずれ %1 mm</translation>
    </message>
    <message>
        <source>ring: 95 % within %1 mm</source>
        <translation>輪: 95 % が %1 mm 以内</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ColourLegend</name>
    <message>
        <source>colour of the pulses: dark is the least value, bright the largest; grey: not known</source>
        <translation>パルスの色: 暗い色が最小値、明るい色が最大値。灰色: 不明</translation>
    </message>
    <message>
        <source>%1 %2 to %3 %4</source>
        <translation>%1 %2〜%3 %4</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ComparePage</name>
    <message>
        <source>The chosen session against</source>
        <translation>選択したセッションの比較相手</translation>
    </message>
    <message>
        <source>the session that the coil had to come back to</source>
        <translation>コイルが戻るべき基準のセッション</translation>
    </message>
    <message>
        <source>target</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>The case has no other session.</source>
        <translation>この症例にほかのセッションはありません。</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>セッションを読み込んでいます</translation>
    </message>
    <message>
        <source>Mean pose of the coil over the pulses that are not excluded, in the MRI; ±: root mean square.</source>
        <translation>除外していないパルスにわたるコイルの平均姿勢 (MRI 座標)。±: 二乗平均平方根。</translation>
    </message>
    <message>
        <source>No target has pulses in both sessions.</source>
        <translation>両方のセッションでパルスのある標的はありません。</translation>
    </message>
    <message>
        <source>Only in the other: %1.</source>
        <translation>比較相手のみ: %1。</translation>
    </message>
    <message>
        <source>Only in the chosen: %1.</source>
        <translation>選択したセッションのみ: %1。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CortexPresenter</name>
    <message>
        <source>Making the cortex</source>
        <translation>皮質を作成しています</translation>
    </message>
    <message>
        <source>no brain model in this case</source>
        <translation>この症例には脳モデルがありません</translation>
    </message>
    <message>
        <source>making the cortex %1 %</source>
        <translation>皮質を作成しています %1 %</translation>
    </message>
    <message>
        <source>median %1 mm, 95 % within %2 mm</source>
        <translation>中央値 %1 mm、95 % が %2 mm 以内</translation>
    </message>
</context>
<context>
    <name>facenav::ui::DistanceLegend</name>
    <message>
        <source>distance of the true surface from the phi-theta model: blue lies below it (a sulcus that the model spans), orange beyond it; the ends of the scale also hold what lies further</source>
        <translation>φ–θ モデルから実際の表面までの距離: 青はモデルより下 (モデルがまたいでいる脳溝)、オレンジはモデルより外側。目盛りの両端にはそれを超える値も含みます</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>facenav::ui::DosePanel</name>
    <message>
        <source>A protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Protocols (*.json)</source>
        <translation>プロトコル (*.json)</translation>
    </message>
    <message>
        <source>A coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>Coils (*.json)</source>
        <translation>コイル (*.json)</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>ファイルを選ぶ …</translation>
    </message>
    <message>
        <source>the case uses this protocol from now on</source>
        <translation>今後、この症例はこのプロトコルを使います</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the case has no protocol from now on</source>
        <translation>今後、この症例にはプロトコルがありません</translation>
    </message>
    <message>
        <source>the target has its own dose</source>
        <translation>標的に固有の刺激量を使う</translation>
    </message>
    <message>
        <source>numbers for this target alone, in place of the protocol&apos;s</source>
        <translation>プロトコルの値に代えて、この標的だけに使う値</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>パルス数</translation>
    </message>
    <message>
        <source>trains</source>
        <translation>トレイン数</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>周波数</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>single pulses</source>
        <translation>単発パルス</translation>
    </message>
    <message>
        <source>pause between trains</source>
        <translation>トレイン間の休止</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source> % of the maximum</source>
        <translation> % (最大出力比)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>of the threshold</source>
        <translation>閾値比</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>takes</source>
        <translation>所要時間</translation>
    </message>
    <message>
        <source>Apply to the target</source>
        <translation>標的に適用</translation>
    </message>
    <message>
        <source>sessions at this target count against these numbers</source>
        <translation>この標的でのセッションはこの値に対して数えます</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>a coil of the library (&apos;facenav coil add&apos;), by its name</source>
        <translation>ライブラリのコイル (&apos;facenav coil add&apos;)。名前で選びます</translation>
    </message>
    <message>
        <source>Choose a coil …</source>
        <translation>コイルを選ぶ …</translation>
    </message>
    <message>
        <source>coil.json; its contact outline rests on the head from now on</source>
        <translation>coil.json。今後、その接触面の輪郭を頭部に置きます</translation>
    </message>
    <message>
        <source>the library holds no coil</source>
        <translation>ライブラリにコイルがありません</translation>
    </message>
    <message>
        <source>choose from the library</source>
        <translation>ライブラリから選ぶ</translation>
    </message>
</context>
<context>
    <name>facenav::ui::EditMenu</name>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直し(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::EditPanel</name>
    <message>
        <source>Correct the brain</source>
        <translation>脳の修正</translation>
    </message>
    <message>
        <source>radius of brush and eraser, depth of the scalpel (Ctrl+wheel over a slice, [ and ])</source>
        <translation>ブラシと消しゴムの半径、メスの深さ (断面上で Ctrl+ホイール、[ と ])</translation>
    </message>
    <message>
        <source>ball (3-D)</source>
        <translation>球 (3-D)</translation>
    </message>
    <message>
        <source>through neighbouring slices as well; else only the slice shown (D)</source>
        <translation>隣の断面にも及びます。オフなら表示中の断面だけです (D)</translation>
    </message>
    <message>
        <source>smaller brush, shallower scalpel</source>
        <translation>ブラシを小さく、メスを浅く</translation>
    </message>
    <message>
        <source>larger brush, deeper scalpel</source>
        <translation>ブラシを大きく、メスを深く</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>add to the brain; Shift takes away</source>
        <translation>脳に加えます。Shift で取り除きます</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>消しゴム</translation>
    </message>
    <message>
        <source>take away; Shift adds</source>
        <translation>取り除きます。Shift で加えます</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>閾値</translation>
    </message>
    <message>
        <source>brush that takes only what looks like the place pressed</source>
        <translation>押した場所と似た値だけを塗るブラシ</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>draw round what is to be added; Shift cuts it off</source>
        <translation>加える範囲を囲みます。Shift で切り取ります</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>領域拡張</translation>
    </message>
    <message>
        <source>add the connected region of similar values; Shift removes it</source>
        <translation>似た値のつながった領域を加えます。Shift で取り除きます</translation>
    </message>
    <message>
        <source>Scalpel</source>
        <translation>メス</translation>
    </message>
    <message>
        <source>draw round a part on the 3-D view: what lies behind it, down to the depth, is cut off</source>
        <translation>3-D 表示で一部を囲みます: その奥を、設定した深さまで切り取ります</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑化</translation>
    </message>
    <message>
        <source>shave spikes off and fill notches</source>
        <translation>突起を削り、くぼみを埋めます</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>穴埋め</translation>
    </message>
    <message>
        <source>what the brain encloses becomes brain</source>
        <translation>脳に囲まれた部分を脳にします</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <translation>補間</translation>
    </message>
    <message>
        <source>the slices between those drawn on, in one orientation</source>
        <translation>描き込んだ断面の間を同じ方向で補間します</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>back to the automatic mask, as a step that can be undone</source>
        <translation>自動マスクに戻します (元に戻せる操作です)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>into the case; a sign-off is void then</source>
        <translation>症例に保存します。承認は無効になります</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>throw the draft away: the case&apos;s own mask again</source>
        <translation>下書きを捨て、症例のマスクに戻します</translation>
    </message>
    <message>
        <source>automatic contour, white</source>
        <translation>自動の輪郭 (白)</translation>
    </message>
    <message>
        <source>show the automatic mask&apos;s contour as well, white (A)</source>
        <translation>自動マスクの輪郭も白で表示します (A)</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>深さ %1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>facenav::ui::EditPresenter</name>
    <message>
        <source>region grow</source>
        <translation>領域拡張</translation>
    </message>
    <message>
        <source>eraser</source>
        <translation>消しゴム</translation>
    </message>
    <message>
        <source>threshold paint</source>
        <translation>閾値ブラシ</translation>
    </message>
    <message>
        <source>brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>lasso, cut</source>
        <translation>投げ縄、切り取り</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>scalpel</source>
        <translation>メス</translation>
    </message>
    <message>
        <source>The brain&apos;s model</source>
        <translation>脳モデル</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>平滑化</translation>
    </message>
    <message>
        <source>fill holes</source>
        <translation>穴埋め</translation>
    </message>
    <message>
        <source>draw on two or more slices of one orientation first, as discs</source>
        <translation>先に同じ方向の断面 2 枚以上に円板状に描き込んでください</translation>
    </message>
    <message>
        <source>interpolate</source>
        <translation>補間</translation>
    </message>
    <message>
        <source>Saving the corrected brain</source>
        <translation>修正した脳を保存しています</translation>
    </message>
    <message>
        <source>no case open</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source>brain %1 ml</source>
        <translation>脳 %1 ml</translation>
    </message>
    <message>
        <source>   not saved (a draft is kept)</source>
        <translation>   未保存 (下書きは残っています)</translation>
    </message>
    <message>
        <source>   %1 slices drawn on</source>
        <translation>   描き込み %1 断面</translation>
    </message>
</context>
<context>
    <name>facenav::ui::EndPanel</name>
    <message>
        <source>not asked</source>
        <translation>未聴取</translation>
    </message>
    <message>
        <source>0: none, 10: the worst imaginable; kept in the session&apos;s log and report</source>
        <translation>0: なし、10: 想像しうる最悪の痛み。セッションの記録とレポートに残ります</translation>
    </message>
    <message>
        <source>pain after</source>
        <translation>終了後の痛み</translation>
    </message>
    <message>
        <source>adverse events, in words; empty: none</source>
        <translation>有害事象 (文章で)。空欄: なし</translation>
    </message>
    <message>
        <source>kept in the session&apos;s log and report</source>
        <translation>セッションの記録とレポートに残ります</translation>
    </message>
    <message>
        <source>End and show the report</source>
        <translation>終了してレポートを表示</translation>
    </message>
    <message>
        <source>closes the session; it can still be read, and continued, later</source>
        <translation>セッションを閉じます。後で読むことも続けることもできます</translation>
    </message>
    <message>
        <source>Back to the session</source>
        <translation>セッションに戻る</translation>
    </message>
    <message>
        <source>the session goes on as it was (Space)</source>
        <translation>セッションはそのまま続きます (Space)</translation>
    </message>
    <message>
        <source>End of the session: %1.</source>
        <translation>セッションの終了: %1。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ExportPresenter</name>
    <message>
        <source>1 target</source>
        <translation>標的 1 個</translation>
    </message>
    <message>
        <source>%1 targets</source>
        <translation>標的 %1 個</translation>
    </message>
    <message>
        <source>1 pulse</source>
        <translation>パルス 1 回</translation>
    </message>
    <message>
        <source>%1 pulses</source>
        <translation>パルス %1 回</translation>
    </message>
    <message>
        <source>Written: %1 in %2</source>
        <translation>書き出しました: %2 に%1</translation>
    </message>
    <message>
        <source> and </source>
        <translation>と</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ExportWindow</name>
    <message>
        <source>FaceNav: export for another program</source>
        <translation>FaceNav: ほかのプログラム用に書き出し</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>書き出す(&amp;W)</translation>
    </message>
    <message>
        <source>writes the file, readable for you alone (Ctrl+Return)</source>
        <translation>ファイルを書き出します。読めるのはあなただけです (Ctrl+Return)</translation>
    </message>
    <message>
        <source>close the window of the export</source>
        <translation>書き出しのウィンドウを閉じます</translation>
    </message>
    <message>
        <source>the program that shall read the file, and what its file holds</source>
        <translation>ファイルを読むプログラムと、ファイルの内容</translation>
    </message>
    <message>
        <source>Space: take the target or leave it out</source>
        <translation>Space: 標的を含める、外す</translation>
    </message>
    <message>
        <source>the session whose pulses go into the file</source>
        <translation>パルスをファイルに書き出すセッション</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>標的(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Pulses</source>
        <translation>パルス(&amp;P)</translation>
    </message>
    <message>
        <source>the name says nothing of the patient unless you type it</source>
        <translation>ファイル名は、入力しない限り患者について何も示しません</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>選択(&amp;C)…</translation>
    </message>
    <message>
        <source>where the file goes</source>
        <translation>ファイルの保存先</translation>
    </message>
    <message>
        <source>&amp;Replace a file of this name</source>
        <translation>同名のファイルを置き換える(&amp;R)</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>ファイル(&amp;I)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>of all sessions</source>
        <translation>すべてのセッション</translation>
    </message>
    <message>
        <source>session %1</source>
        <translation>%1 のセッション</translation>
    </message>
    <message>
        <source>Export for another program</source>
        <translation>ほかのプログラム用に書き出し</translation>
    </message>
    <message>
        <source>tick a target first</source>
        <translation>先に標的にチェックを入れてください</translation>
    </message>
    <message>
        <source>name the file first</source>
        <translation>先にファイル名を入力してください</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldMapPresenter</name>
    <message>
        <source>MEPs by field</source>
        <translation>電場による MEP</translation>
    </message>
    <message>
        <source>the case has no brain, so its field is not known</source>
        <translation>この症例には脳がないため、電場は分かりません</translation>
    </message>
    <message>
        <source>computing the fields of the pulses …</source>
        <translation>パルスの電場を計算しています …</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldPanel</name>
    <message>
        <source>Electric field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>the field that the planned coil induces, in colours on the brain, in V/m</source>
        <translation>計画したコイルが誘導する電場を、脳の上に色で示します (V/m)</translation>
    </message>
    <message>
        <source>whose field it is: a built-in coil, or a file (.ccd .tcd .nii.gz) of SimNIBS</source>
        <translation>どのコイルの電場か: 内蔵のコイル、または SimNIBS のファイル (.ccd .tcd .nii.gz)</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>rate of the current</source>
        <translation>電流変化率</translation>
    </message>
    <message>
        <source>A/us</source>
        <translation>A/us</translation>
    </message>
    <message>
        <source>% of the output</source>
        <translation>出力の %</translation>
    </message>
    <message>
        <source>how fast the coil&apos;s current rises; % if the coil&apos;s file states its largest rate</source>
        <translation>コイル電流の立ち上がりの速さ。コイルのファイルに最大変化率があれば % で指定できます</translation>
    </message>
    <message>
        <source>current</source>
        <translation>電流</translation>
    </message>
    <message>
        <source>imported field (tier 3)</source>
        <translation>取り込んだ電場 (段階 3)</translation>
    </message>
    <message>
        <source>the field that another program computed for this pose, in place of the case&apos;s own model; only for the pose for which it was imported</source>
        <translation>症例自身のモデルに代えて、ほかのプログラムがこの姿勢で計算した電場を使います。取り込んだときの姿勢にだけ有効です</translation>
    </message>
    <message>
        <source>what gets at least 50, 75 and 90 % of the maximum: area of the cortex&apos; surface; volume of the brain mask, grey and white matter together, by AAL label in ml</source>
        <translation>最大値の 50、75、90 % 以上となる範囲: 皮質表面の面積、脳マスク (灰白質と白質の合計) の体積を AAL ラベル別に ml で示します</translation>
    </message>
    <message>
        <source>measuring the region …</source>
        <translation>範囲を計測しています …</translation>
    </message>
    <message>
        <source>builds the head&apos;s model with the fluid round the brain (tier 2), which changes the field most; needs 2 GB of memory meanwhile; the case keeps it</source>
        <translation>電場を最も大きく変える髄液を含む頭部モデル (段階 2) を作成します。作成中は 2 GB のメモリーが必要です。症例に保存されます</translation>
    </message>
    <message>
        <source>A coil&apos;s field</source>
        <translation>コイルの電場</translation>
    </message>
    <message>
        <source>Coils (*.ccd *.tcd *.nii *.nii.gz)</source>
        <translation>コイル (*.ccd *.tcd *.nii *.nii.gz)</translation>
    </message>
    <message>
        <source>figure-8, 70 mm</source>
        <translation>8 の字、70 mm</translation>
    </message>
    <message>
        <source>round, 90 mm</source>
        <translation>円形、90 mm</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>ファイルを選ぶ …</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldPresenter</name>
    <message>
        <source>Electric field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>maximum %1 V/m</source>
        <translation>最大 %1 V/m</translation>
    </message>
    <message>
        <source>dose by field: %1 % of the output gives this target the field that %2 had at its threshold of %3 %</source>
        <translation>電場による刺激量: 出力 %1 % で、この標的の電場が %2 の閾値 %3 % のときの電場と等しくなります</translation>
    </message>
    <message>
        <source>: more than the stimulator has</source>
        <translation>: 刺激装置の最大出力を超えています</translation>
    </message>
    <message>
        <source>a local sphere</source>
        <translation>局所球</translation>
    </message>
    <message>
        <source>three shells</source>
        <translation>3 層</translation>
    </message>
    <message>
        <source>four shells with the fluid</source>
        <translation>髄液を含む 4 層</translation>
    </message>
    <message>
        <source>imported field</source>
        <translation>取り込んだ電場</translation>
    </message>
    <message>
        <source>%1 % at the target, maximum %2 mm away, correlation %3</source>
        <translation>標的で %1 %、最大点のずれ %2 mm、相関 %3</translation>
    </message>
    <message>
        <source>cortex</source>
        <translation>皮質</translation>
    </message>
    <message>
        <source>the brain&apos;s hull</source>
        <translation>脳の外郭面</translation>
    </message>
    <message>
        <source>above %1 %: %2 mm² of %3, %4 ml of the brain</source>
        <translation>%1 % 以上: %3 %2 mm²、脳 %4 ml</translation>
    </message>
    <message>
        <source>against &apos;%1&apos;: %2</source>
        <translation>&apos;%1&apos; との比較: %2</translation>
    </message>
    <message>
        <source>; the three shells are older than the masks and could not be built again: %1</source>
        <translation>; 3 層モデルがマスクより古く、作り直せませんでした: %1</translation>
    </message>
    <message>
        <source>; the three shells are older than the masks and are being built again</source>
        <translation>; 3 層モデルがマスクより古いため、作り直しています</translation>
    </message>
    <message>
        <source>; the three shells are older than the masks</source>
        <translation>; 3 層モデルがマスクより古くなっています</translation>
    </message>
    <message>
        <source>no target chosen, so there is no field</source>
        <translation>標的が選ばれていないため、電場はありません</translation>
    </message>
    <message>
        <source>computing the electric field …</source>
        <translation>電場を計算しています …</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>E at target %1 V/m, along the normal %2; maximum %3 V/m, %4 mm from the target</source>
        <translation>標的での E %1 V/m、法線方向 %2; 最大 %3 V/m、標的から %4 mm</translation>
    </message>
    <message>
        <source>; at %1 A/us; tier %2: %3, usual error %4 %</source>
        <translation>; %1 A/us で; 段階 %2: %3、典型誤差 %4 %</translation>
    </message>
    <message>
        <source>; no model with the fluid: %1</source>
        <translation>; 髄液を含むモデルなし: %1</translation>
    </message>
    <message>
        <source>; at %1 A/us; imported field (tier 3): its own maximum %2 V/m and 99.9th percentile %3 V/m at %4 A/us</source>
        <translation>; %1 A/us で; 取り込んだ電場 (段階 3): %4 A/us で元の最大値 %2 V/m、99.9 パーセンタイル %3 V/m</translation>
    </message>
    <message>
        <source>|E|, tier %1</source>
        <translation>|E|、段階 %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldQueue</name>
    <message>
        <source>Electric field</source>
        <translation>電場</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldView</name>
    <message>
        <source>strength of the electric field on the brain; below a fifth of the maximum it is not coloured; the white lines are 50, 75 and 90 % of it; the slices show the same colours</source>
        <translation>脳の上の電場の強さ。最大値の 5 分の 1 未満は色を付けません。白い線は最大値の 50、75、90 %。断面にも同じ色で示します</translation>
    </message>
    <message>
        <source>of the planned pose; what the numbers mean: the manual&apos;s page &apos;Field&apos;</source>
        <translation>計画した姿勢の値です。数値の意味: マニュアルの「Field」のページ</translation>
    </message>
    <message>
        <source>what the pose of the target that you compare with would give: strength at the active target, place of the maximum, and the correlation of both fields on the cortex</source>
        <translation>比較する標的の姿勢ならどうなるか: 選択中の標的での強さ、最大点の位置、皮質上の両電場の相関</translation>
    </message>
    <message>
        <source>strongest</source>
        <translation>最強</translation>
    </message>
    <message>
        <source>along normal</source>
        <translation>法線方向</translation>
    </message>
    <message>
        <source>aim of the best pose</source>
        <translation>最良の姿勢の目的</translation>
    </message>
    <message>
        <source>what the best pose gives most of: field at the target, or its part along the normal of the cortex there</source>
        <translation>最良の姿勢が最大にするもの: 標的での電場、またはその皮質の法線方向の成分</translation>
    </message>
    <message>
        <source>Best angle and place</source>
        <translation>最良の角度と位置</translation>
    </message>
    <message>
        <source>tries 36 angles at 25 places within 2 x 2 cm; the target stays until you take it</source>
        <translation>2 x 2 cm 内の 25 か所で 36 通りの角度を試します。採用するまで標的は変わりません</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>gives the target the pose that was found; Undo takes it back</source>
        <translation>見つかった姿勢を標的に設定します。「元に戻す」で取り消せます</translation>
    </message>
    <message>
        <source>no field</source>
        <translation>電場なし</translation>
    </message>
    <message>
        <source>V/m</source>
        <translation>V/m</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FiguresPanel</name>
    <message>
        <source>across, mm</source>
        <translation>横ずれ (mm)</translation>
    </message>
    <message>
        <source>depth, mm</source>
        <translation>深さ (mm)</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>ねじれ</translation>
    </message>
    <message>
        <source>distance of the coil&apos;s centre from the target, across the target&apos;s axis</source>
        <translation>標的からコイル中心までの距離 (標的の軸に垂直な方向)</translation>
    </message>
    <message>
        <source>along the target&apos;s axis: + too deep, - stands off</source>
        <translation>標的の軸に沿った距離: + は深すぎ、- は離れています</translation>
    </message>
    <message>
        <source>angle between the coil&apos;s axis and the target&apos;s</source>
        <translation>コイルの軸と標的の軸の間の角度</translation>
    </message>
    <message>
        <source>turn of the handle that is left, about the axis</source>
        <translation>軸まわりに残っているハンドルの回転</translation>
    </message>
    <message>
        <source>error of the alignment at the target: 95 of 100 such alignments keep within it</source>
        <translation>標的での位置合わせの誤差: このような位置合わせ 100 回のうち 95 回がこの範囲に収まります</translation>
    </message>
    <message>
        <source>the second coil against its own target; it is the faint coil in the scene</source>
        <translation>第 2 コイルと、その標的との差。シーンでは薄く表示されるコイルです</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FluidPresenter</name>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>開始しています</translation>
    </message>
    <message>
        <source>Electric field with the fluid</source>
        <translation>髄液を含む電場</translation>
    </message>
    <message>
        <source>%1: stop</source>
        <translation>%1: 中止</translation>
    </message>
    <message>
        <source>with the fluid: built</source>
        <translation>髄液を含む: 作成済み</translation>
    </message>
    <message>
        <source>with the fluid (takes about %1 s)</source>
        <translation>髄液を含む (約 %1 s)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::GridPanel</name>
    <message>
        <source>rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>on the scalp</source>
        <translation>頭皮上</translation>
    </message>
    <message>
        <source>on the cortex</source>
        <translation>皮質上</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定方法</translation>
    </message>
    <message>
        <source>Make the grid</source>
        <translation>格子を作成</translation>
    </message>
    <message>
        <source>targets round the active one, handles along the curvature; edited ones stay</source>
        <translation>選択中の標的を囲む標的。ハンドルは曲面に沿います。編集した標的はそのまま残ります</translation>
    </message>
    <message>
        <source>Remove the grid</source>
        <translation>格子を削除</translation>
    </message>
    <message>
        <source>removes its targets; those that were edited by hand stay</source>
        <translation>格子の標的を削除します。手で編集したものは残ります</translation>
    </message>
    <message>
        <source>Making the grid …</source>
        <translation>格子を作成しています …</translation>
    </message>
</context>
<context>
    <name>facenav::ui::GuidanceScreen</name>
    <message>
        <source>MOVE</source>
        <translation>動かす</translation>
    </message>
    <message>
        <source>LIFT</source>
        <translation>離す</translation>
    </message>
    <message>
        <source>PRESS</source>
        <translation>近づける</translation>
    </message>
    <message>
        <source>TILT</source>
        <translation>傾ける</translation>
    </message>
    <message>
        <source>TURN</source>
        <translation>回す</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>ALIGN AGAIN</source>
        <translation>再位置合わせ</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>FaceNav: guidance</source>
        <translation>FaceNav: 誘導</translation>
    </message>
    <message>
        <source>%1 mm away</source>
        <translation>あと %1 mm</translation>
    </message>
</context>
<context>
    <name>facenav::ui::HandlePanel</name>
    <message>
        <source>handle, degrees</source>
        <translation>ハンドル (度)</translation>
    </message>
    <message>
        <source>handle angle, -180 to 180 degrees: 0 points straight back, + turns its front to the midline (Return)</source>
        <translation>ハンドルの角度、-180〜180 度: 0 は真後ろ、+ は前側を正中線へ向けます (Return)</translation>
    </message>
    <message>
        <source>gap, mm</source>
        <translation>隙間 (mm)</translation>
    </message>
    <message>
        <source>between coil and skin, for hair: 0 to 20 mm (Return)</source>
        <translation>コイルと皮膚の間の、髪のための隙間: 0〜20 mm (Return)</translation>
    </message>
    <message>
        <source>↺ 5°</source>
        <translation>↺ 5°</translation>
    </message>
    <message>
        <source>↻ 5°</source>
        <translation>↻ 5°</translation>
    </message>
    <message>
        <source>turn the handle anticlockwise, seen from above the coil (Ctrl+left arrow while a view has the focus)</source>
        <translation>コイルの上から見て反時計回りにハンドルを回します (表示がフォーカスされているとき Ctrl+左矢印)</translation>
    </message>
    <message>
        <source>turn the handle clockwise, seen from above the coil (Ctrl+right arrow while a view has the focus)</source>
        <translation>コイルの上から見て時計回りにハンドルを回します (表示がフォーカスされているとき Ctrl+右矢印)</translation>
    </message>
    <message>
        <source>handle °</source>
        <translation>ハンドル °</translation>
    </message>
    <message>
        <source>gap mm</source>
        <translation>隙間 mm</translation>
    </message>
    <message>
        <source>handle: 0° points straight back, + turns its front to the midline; over forehead and occiput it is measured from superior; below: how the coil&apos;s plate stands on the head</source>
        <translation>ハンドル: 0° は真後ろ、+ は前側を正中線へ向けます。前額部と後頭部では上方を基準に測ります。下: コイル面と頭部の接し方</translation>
    </message>
</context>
<context>
    <name>facenav::ui::HeadPresenter</name>
    <message>
        <source>nasion</source>
        <translation>鼻根点</translation>
    </message>
    <message>
        <source>inion</source>
        <translation>後頭結節</translation>
    </message>
    <message>
        <source>left tragus</source>
        <translation>左耳珠</translation>
    </message>
    <message>
        <source>right tragus</source>
        <translation>右耳珠</translation>
    </message>
    <message>
        <source>%1: not found, set it</source>
        <translation>%1: 見つかりません。設定してください</translation>
    </message>
    <message>
        <source>found</source>
        <translation>自動検出</translation>
    </message>
    <message>
        <source>by the atlas</source>
        <translation>アトラスによる</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>%1: %2, ± %3 mm%4</source>
        <translation>%1: %2、± %3 mm%4</translation>
    </message>
    <message>
        <source>, at the scan&apos;s edge</source>
        <translation>、スキャンの端</translation>
    </message>
</context>
<context>
    <name>facenav::ui::HelpWindow</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>All pages</source>
        <translation>全ページ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>the page before (Alt+Left)</source>
        <translation>前のページ (Alt+Left)</translation>
    </message>
    <message>
        <source>the list of the manual&apos;s pages</source>
        <translation>マニュアルのページ一覧</translation>
    </message>
    <message>
        <source>closes the help (Esc)</source>
        <translation>ヘルプを閉じます (Esc)</translation>
    </message>
    <message>
        <source>help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>help for this page</source>
        <translation>この画面のヘルプ</translation>
    </message>
    <message>
        <source>FaceNav help: %1</source>
        <translation>FaceNav ヘルプ: %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::HomePresenter</name>
    <message>
        <source>Opening</source>
        <translation>開いています</translation>
    </message>
    <message>
        <source>START</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>TRY AGAIN</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>OPEN THE CAMERAS</source>
        <translation>カメラを開く</translation>
    </message>
    <message>
        <source>TAKE THE PICTURE</source>
        <translation>撮影する</translation>
    </message>
    <message>
        <source>YES, FINISH</source>
        <translation>はい、終了します</translation>
    </message>
    <message>
        <source>FINISH</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>SAVE THE FILE TO SEND</source>
        <translation>送るファイルを保存</translation>
    </message>
    <message>
        <source>CLOSE</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>One moment.</source>
        <translation>お待ちください。</translation>
    </message>
    <message>
        <source>This case cannot be used here: call the clinic.</source>
        <translation>この症例はここでは使えません: 病院に電話してください。</translation>
    </message>
    <message>
        <source>Sit still, look at the cameras, and press START.</source>
        <translation>静かに座ってカメラを見て、「開始」を押してください。</translation>
    </message>
    <message>
        <source>Look at the cameras, and hold the coil still beside the face, its marker to them.</source>
        <translation>カメラを見て、コイルを顔の横に持ち、マーカーをカメラに向けたまま動かさないでください。</translation>
    </message>
    <message>
        <source>Press the button, look at the cameras, and hold the coil still beside the face.</source>
        <translation>ボタンを押し、カメラを見て、コイルを顔の横に持ったまま動かさないでください。</translation>
    </message>
    <message>
        <source>Sit still: your face is being measured.</source>
        <translation>動かずに座っていてください: 顔を計測しています。</translation>
    </message>
    <message>
        <source>The session is being closed.</source>
        <translation>セッションを閉じています。</translation>
    </message>
    <message>
        <source>Saved: send this file to the clinic.</source>
        <translation>保存しました: このファイルを病院に送ってください。</translation>
    </message>
    <message>
        <source>Finished: save the file, and send it to the clinic.</source>
        <translation>終わりました: ファイルを保存して、病院に送ってください。</translation>
    </message>
    <message>
        <source>Finished without a pulse on target: save the file, and call the clinic.</source>
        <translation>標的上のパルスがないまま終わりました: ファイルを保存して、病院に電話してください。</translation>
    </message>
    <message>
        <source>Finish now? Press the button again. To go on, wait or press Esc.</source>
        <translation>終了しますか? もう一度ボタンを押してください。続ける場合は、待つか Esc を押してください。</translation>
    </message>
    <message>
        <source>Measuring the face</source>
        <translation>顔を計測しています</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>開始しています</translation>
    </message>
    <message>
        <source>The coil&apos;s calibration is old or not recorded: tell the clinic.</source>
        <translation>コイルの較正が古いか、記録がありません: 病院に連絡してください。</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>閉じています</translation>
    </message>
</context>
<context>
    <name>facenav::ui::HomeWindow</name>
    <message>
        <source>FaceNav at home</source>
        <translation>FaceNav 在宅</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
    <message>
        <source>Save the file to send</source>
        <translation>送るファイルを保存</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>1  Sit and look</source>
        <translation>1  座って見る</translation>
    </message>
    <message>
        <source>2  Hold the coil</source>
        <translation>2  コイルを持つ</translation>
    </message>
    <message>
        <source>3  Follow the arrow</source>
        <translation>3  矢印に従う</translation>
    </message>
    <message>
        <source>on the desktop</source>
        <translation>デスクトップ</translation>
    </message>
    <message>
        <source>on the USB stick %1</source>
        <translation>USB メモリー %1</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1 of %2 pulses on target</source>
        <translation>%2 パルス中 %1 が標的上</translation>
    </message>
    <message>
        <source>%1 pulses on target</source>
        <translation>標的上のパルス %1</translation>
    </message>
    <message>
        <source>, %1 not on target</source>
        <translation>、標的上でないもの %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportChoices</name>
    <message>
        <source>as the file says</source>
        <translation>ファイルの指定どおり</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>axes of the file&apos;s coordinates: x right or left, y anterior or posterior</source>
        <translation>ファイルの座標軸: x は右または左、y は前または後</translation>
    </message>
    <message>
        <source>sform</source>
        <translation>sform</translation>
    </message>
    <message>
        <source>qform</source>
        <translation>qform</translation>
    </message>
    <message>
        <source>the form of the T1&apos;s NIfTI that the coordinates mean; open only where they differ</source>
        <translation>座標が指す T1 の NIfTI の変換 (form)。両者が異なる場合だけ選べます</translation>
    </message>
    <message>
        <source>Coo&amp;rdinates</source>
        <translation>座標(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>変換(&amp;F)</translation>
    </message>
    <message>
        <source>as the format says</source>
        <translation>形式の規定どおり</translation>
    </message>
    <message>
        <source>as written</source>
        <translation>記載どおり</translation>
    </message>
    <message>
        <source>the other way</source>
        <translation>逆向き</translation>
    </message>
    <message>
        <source>where the handles point; the other way turns the coils by 180 degrees about their axis</source>
        <translation>ハンドルの向き。逆向きにすると、コイルを軸まわりに 180 度回します</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>x to the nasion</source>
        <translation>x は鼻根点へ</translation>
    </message>
    <message>
        <source>x to the right ear</source>
        <translation>x は右耳へ</translation>
    </message>
    <message>
        <source>of coordinates that lie between the ears; the file does not say which way x points</source>
        <translation>両耳の間に原点がある座標について。x の向きがファイルに書かれていません</translation>
    </message>
    <message>
        <source>Re&amp;place</source>
        <translation>置き換える(&amp;P)</translation>
    </message>
    <message>
        <source>targets of the same name with another pose; locked ones stay</source>
        <translation>名前が同じで姿勢が異なる標的を置き換えます。ロックされた標的は残ります</translation>
    </message>
    <message>
        <source>&amp;Handle</source>
        <translation>ハンドル(&amp;H)</translation>
    </message>
    <message>
        <source>Head fra&amp;me</source>
        <translation>頭部座標系(&amp;M)</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>hours that the clock of the file&apos;s pulses is ahead of UTC</source>
        <translation>ファイルのパルスの時計が UTC より進んでいる時間</translation>
    </message>
    <message>
        <source>C&amp;lock ahead of UTC</source>
        <translation>時計の UTC との差(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;T1…</source>
        <translation>T1(&amp;T)…</translation>
    </message>
    <message>
        <source>the NIfTI that the other program used, if it is not the case&apos;s own</source>
        <translation>ほかのプログラムが使った NIfTI (症例の T1 と異なる場合)</translation>
    </message>
    <message>
        <source>The case&apos;s</source>
        <translation>症例の T1</translation>
    </message>
    <message>
        <source>judges the file by the case&apos;s own T1 again</source>
        <translation>症例自身の T1 でファイルを判定し直します</translation>
    </message>
    <message>
        <source>The T1 that the other program used</source>
        <translation>ほかのプログラムが使った T1</translation>
    </message>
    <message>
        <source>NIfTI (*.nii *.nii.gz);;All files (*)</source>
        <translation>NIfTI (*.nii *.nii.gz);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>What %1 leaves open</source>
        <translation>%1 で指定が必要な項目</translation>
    </message>
    <message>
        <source>the case&apos;s own</source>
        <translation>症例の T1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportList</name>
    <message>
        <source>cannot be read: %1</source>
        <translation>読み込めません: %1</translation>
    </message>
    <message>
        <source>; %1 refused</source>
        <translation>; 取り込み不可 %1</translation>
    </message>
    <message>
        <source>%1 pulses, %2 with a pose</source>
        <translation>パルス %1 回、うち姿勢あり %2 回</translation>
    </message>
    <message>
        <source>, %1 refused</source>
        <translation>、取り込み不可 %1</translation>
    </message>
    <message>
        <source>what the files hold</source>
        <translation>ファイルの内容</translation>
    </message>
    <message>
        <source>Space: take in or leave out   arrows: choose, open and close</source>
        <translation>Space: 取り込む、外す   矢印キー: 選択、開閉</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>place (RAS, mm)</source>
        <translation>位置 (RAS、mm)</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source> (see below)</source>
        <translation> (下記参照)</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportPresenter</name>
    <message>
        <source>Reading the files</source>
        <translation>ファイルを読み込んでいます</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>読み込んでいます …</translation>
    </message>
    <message>
        <source>1 target</source>
        <translation>標的 1 個</translation>
    </message>
    <message>
        <source>%1 targets</source>
        <translation>標的 %1 個</translation>
    </message>
    <message>
        <source>1 pulse</source>
        <translation>パルス 1 回</translation>
    </message>
    <message>
        <source>%1 pulses</source>
        <translation>パルス %1 回</translation>
    </message>
    <message>
        <source>nothing comes in</source>
        <translation>取り込むものはありません</translation>
    </message>
    <message>
        <source> and </source>
        <translation>と</translation>
    </message>
    <message>
        <source> comes in</source>
        <translation>を取り込みます</translation>
    </message>
    <message>
        <source> come in</source>
        <translation>を取り込みます</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>取り込み不可 %1</translation>
    </message>
    <message>
        <source>%1 here already</source>
        <translation>既存 %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportView</name>
    <message>
        <source>the head with the coils of the files</source>
        <translation>ファイルのコイルを示した頭部</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportWindow</name>
    <message>
        <source>FaceNav: targets from another navigator</source>
        <translation>FaceNav: ほかのナビゲーターの標的</translation>
    </message>
    <message>
        <source>close; nothing comes in</source>
        <translation>閉じます。何も取り込みません</translation>
    </message>
    <message>
        <source>Tick &amp;all</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>Tick &amp;none</source>
        <translation>すべて解除(&amp;N)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>nothing comes in (Esc)</source>
        <translation>何も取り込みません (Esc)</translation>
    </message>
    <message>
        <source>&amp;Bring in</source>
        <translation>取り込む(&amp;B)</translation>
    </message>
    <message>
        <source>writes what is ticked into the case; one step to undo (Ctrl+Return)</source>
        <translation>チェックしたものを症例に書き込みます。1 回の操作として元に戻せます (Ctrl+Return)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::LatencyScreen</name>
    <message>
        <source>FaceNav: time from the camera to the screen</source>
        <translation>FaceNav: カメラから画面までの時間</translation>
    </message>
    <message>
        <source>point the left camera at this window and let it fill the picture (%1 %)</source>
        <translation>左カメラをこのウィンドウに向け、画像いっぱいに写してください (%1 %)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::LinkedViews</name>
    <message>
        <source>true cortex, coloured by its distance from the model</source>
        <translation>実際の皮質。モデルからの距離で色付け</translation>
    </message>
    <message>
        <source>the slices as they were at first: whole, usual brightness</source>
        <translation>断面を最初の状態に戻します: 全体表示、標準の明るさ</translation>
    </message>
    <message>
        <source>φ–θ model</source>
        <translation>φ–θ モデル</translation>
    </message>
    <message>
        <source>turn either view, both follow</source>
        <translation>どちらかの表示を回すと、両方が動きます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::LiveFieldPresenter</name>
    <message>
        <source>maximum %1 %2</source>
        <translation>最大 %1 %2</translation>
    </message>
    <message>
        <source>V/m</source>
        <translation>V/m</translation>
    </message>
    <message>
        <source>V/m per A/us</source>
        <translation>V/m (A/us あたり)</translation>
    </message>
    <message>
        <source>|E|, tier %1</source>
        <translation>|E|、段階 %1</translation>
    </message>
    <message>
        <source>for 1 A/us: the coil&apos;s file does not say its rate</source>
        <translation>1 A/us あたりの値: コイルのファイルに変化率がありません</translation>
    </message>
    <message>
        <source>at %1 % of the output (%2 A/us)</source>
        <translation>出力 %1 % (%2 A/us) で</translation>
    </message>
    <message>
        <source>at %1 A/us, as set in Plan</source>
        <translation>計画の設定 %1 A/us で</translation>
    </message>
    <message>
        <source>, %1 % of the planned pose</source>
        <translation>、計画した姿勢の %1 %</translation>
    </message>
    <message>
        <source>, %1 % of the motor threshold</source>
        <translation>、運動閾値の %1 %</translation>
    </message>
    <message>
        <source>no field: no case is open</source>
        <translation>電場なし: 症例が開かれていません</translation>
    </message>
    <message>
        <source>no field: %1</source>
        <translation>電場なし: %1</translation>
    </message>
    <message>
        <source>no field: the case has no brain</source>
        <translation>電場なし: 症例に脳がありません</translation>
    </message>
    <message>
        <source>no field in a pause</source>
        <translation>一時停止中は電場なし</translation>
    </message>
    <message>
        <source>no field: the pose of head or coil is not known</source>
        <translation>電場なし: 頭またはコイルの姿勢が不明です</translation>
    </message>
    <message>
        <source>computing the electric field …</source>
        <translation>電場を計算しています …</translation>
    </message>
    <message>
        <source>E at target %1 %2 (%3 to %4)</source>
        <translation>標的での E %1 %2 (%3〜%4)</translation>
    </message>
    <message>
        <source>, %1 mm from the target</source>
        <translation>、標的から %1 mm</translation>
    </message>
    <message>
        <source>measured gap %1 mm; </source>
        <translation>隙間の実測値 %1 mm; </translation>
    </message>
    <message>
        <source>tier %1: %2, usual error %3 %</source>
        <translation>段階 %1: %2、典型誤差 %3 %</translation>
    </message>
</context>
<context>
    <name>facenav::ui::LiveFieldView</name>
    <message>
        <source>strength of the electric field on the brain; below a fifth of the maximum it is not coloured; the white lines are 50, 75 and 90 % of it</source>
        <translation>脳の上の電場の強さ。最大値の 5 分の 1 未満は色を付けません。白い線は最大値の 50、75、90 %</translation>
    </message>
    <message>
        <source>of the coil as it is held now, with its measured gap. In brackets: the range that the model&apos;s usual error, and the 95 % bound of the coil&apos;s pose, leave possible. What the numbers mean: the manual&apos;s page &apos;Field&apos;</source>
        <translation>今のコイルの持ち方と隙間の実測値での値です。括弧内: モデルの典型誤差とコイル姿勢の 95 % 範囲から考えられる値の幅。数値の意味: マニュアルの「Field」のページ</translation>
    </message>
    <message>
        <source>no field</source>
        <translation>電場なし</translation>
    </message>
    <message>
        <source>V/m</source>
        <translation>V/m</translation>
    </message>
</context>
<context>
    <name>facenav::ui::MainWindow</name>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help for this page</source>
        <translation>この画面のヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>&amp;About FaceNav</source>
        <translation>FaceNav について(&amp;A)</translation>
    </message>
    <message>
        <source>About FaceNav</source>
        <translation>FaceNav について</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>準備</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>Treat</source>
        <translation>治療</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>レビュー</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>end the guidance first: the cameras are in use</source>
        <translation>先に誘導を終了してください: カメラが使用中です</translation>
    </message>
    <message>
        <source>wait for the running task to end, or cancel it: it may use the cameras</source>
        <translation>実行中の処理が終わるまで待つか、キャンセルしてください: カメラを使っている可能性があります</translation>
    </message>
    <message>
        <source>open the calibrated cameras first (Treat, Cameras)</source>
        <translation>先に較正済みのカメラを開いてください (治療、カメラ)</translation>
    </message>
    <message>
        <source>Keep the projector&apos;s calibration</source>
        <translation>プロジェクターの較正を保存</translation>
    </message>
    <message>
        <source>Calibration (*.yml)</source>
        <translation>較正 (*.yml)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>症例を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a case</source>
        <translation>症例を開く</translation>
    </message>
    <message>
        <source>&amp;Read DICOM folder…</source>
        <translation>DICOM フォルダーを読み込む(&amp;R)…</translation>
    </message>
    <message>
        <source>I&amp;mport targets from another navigator…</source>
        <translation>ほかのナビゲーターの標的を取り込む(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Export for another program…</source>
        <translation>ほかのプログラム用に書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Set up the cameras…</source>
        <translation>カメラの設定(&amp;S)…</translation>
    </message>
    <message>
        <source>Calibrate the &amp;projector…</source>
        <translation>プロジェクターの較正(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>文字サイズ(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>配置を初期状態に戻す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Picture of the window…</source>
        <translation>ウィンドウの画像を保存(&amp;P)…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>FaceNav</source>
        <translation>FaceNav</translation>
    </message>
    <message>
        <source>Drop DICOM folders, NIfTI files or a case anywhere.</source>
        <translation>DICOM フォルダー、NIfTI ファイル、症例は、どこにでもドロップできます。</translation>
    </message>
    <message>
        <source>case %1 is prepared: check it</source>
        <translation>症例 %1 の準備ができました: 確認してください</translation>
    </message>
    <message>
        <source>%1: %2, choose one</source>
        <translation>%1: %2。1 つ選んでください</translation>
    </message>
    <message>
        <source>▣
Prepare</source>
        <translation>▣
準備</translation>
    </message>
    <message>
        <source>◎
Plan</source>
        <translation>◎
計画</translation>
    </message>
    <message>
        <source>✚
Treat</source>
        <translation>✚
治療</translation>
    </message>
    <message>
        <source>≡
Review</source>
        <translation>≡
レビュー</translation>
    </message>
    <message>
        <source>MRI to case: series, masks, brain (Ctrl+1)</source>
        <translation>MRI から症例へ: シリーズ、マスク、脳 (Ctrl+1)</translation>
    </message>
    <message>
        <source>targets on the cortex (Ctrl+2)</source>
        <translation>皮質上の標的 (Ctrl+2)</translation>
    </message>
    <message>
        <source>align and guide the coil (Ctrl+3)</source>
        <translation>位置合わせとコイルの誘導 (Ctrl+3)</translation>
    </message>
    <message>
        <source>what was given, replay, report (Ctrl+4)</source>
        <translation>実施した照射、再生、レポート (Ctrl+4)</translation>
    </message>
    <message>
        <source>guidance was running when the window went: Treat offers to go on with that session</source>
        <translation>誘導中にウィンドウが閉じました: 治療の画面でそのセッションを続けられます</translation>
    </message>
    <message>
        <source>no case open</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source> (override by %1)</source>
        <translation> (%1 による例外)</translation>
    </message>
    <message>
        <source>case %1</source>
        <translation>症例 %1</translation>
    </message>
    <message>
        <source>%1 (case %2)</source>
        <translation>%1 (症例 %2)</translation>
    </message>
    <message>
        <source>A session is running. Close the window?</source>
        <translation>セッションが実行中です。ウィンドウを閉じますか?</translation>
    </message>
    <message>
        <source>A session that is closed at once can be continued later.</source>
        <translation>すぐに閉じたセッションは、後で続けられます。</translation>
    </message>
    <message>
        <source>Keep the session</source>
        <translation>セッションを続ける</translation>
    </message>
    <message>
        <source>End the session…</source>
        <translation>セッションを終了…</translation>
    </message>
    <message>
        <source>Close at once</source>
        <translation>すぐに閉じる</translation>
    </message>
    <message>
        <source>%1 is no file of another navigator, no case and no scan</source>
        <translation>%1 は、ほかのナビゲーターのファイルでも、症例でも、スキャンでもありません</translation>
    </message>
    <message>
        <source>open the case first that the targets belong to</source>
        <translation>先に標的が属する症例を開いてください</translation>
    </message>
    <message>
        <source>Import targets from another navigator</source>
        <translation>ほかのナビゲーターの標的を取り込む</translation>
    </message>
    <message>
        <source>open the case first that shall be exported</source>
        <translation>先に書き出す症例を開いてください</translation>
    </message>
</context>
<context>
    <name>facenav::ui::MapLegend</name>
    <message>
        <source>colours of the maps: negative on the left, positive on the right; smaller values are not shown</source>
        <translation>マップの色: 左が負、右が正。それより小さい値は表示しません</translation>
    </message>
    <message>
        <source>%1  ±%2 %3</source>
        <translation>%1  ±%2 %3</translation>
    </message>
</context>
<context>
    <name>facenav::ui::MontageView</name>
    <message>
        <source>skin orange, brain blue; double click: look at this place on the large slices</source>
        <translation>皮膚はオレンジ、脳は青。ダブルクリック: この位置を大きな断面で見ます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::MotorPanel</name>
    <message>
        <source>estimate and 95 % interval of the motor threshold, % of the maximal output</source>
        <translation>運動閾値の推定値と 95 % 区間 (最大出力に対する %)</translation>
    </message>
    <message>
        <source>from the electric fields of hotspot and target, each at its planned pose; nothing is set by itself</source>
        <translation>計画した姿勢でのホットスポットと標的の電場から求めます。自動で設定されるものはありません</translation>
    </message>
    <message>
        <source>output that the stimulator is set to, %; kept with each pulse</source>
        <translation>刺激装置に設定した出力 (%)。各パルスに記録されます</translation>
    </message>
    <message>
        <source>output, %</source>
        <translation>出力 (%)</translation>
    </message>
    <message>
        <source>peak-to-peak MEP of the pulse named below, uV; Enter keeps it</source>
        <translation>下に示すパルスのピーク間 MEP (uV)。Enter で記録します</translation>
    </message>
    <message>
        <source>MEP, uV</source>
        <translation>MEP (uV)</translation>
    </message>
    <message>
        <source>Yes, it moved</source>
        <translation>はい、動いた</translation>
    </message>
    <message>
        <source>the muscle moved at the pulse named above (Y)</source>
        <translation>上に示すパルスで筋が動きました (Y)</translation>
    </message>
    <message>
        <source>No</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>the muscle did not move at the pulse named above (N)</source>
        <translation>上に示すパルスで筋が動きませんでした (N)</translation>
    </message>
    <message>
        <source>Bayes, 20 pulses</source>
        <translation>ベイズ法、20 パルス</translation>
    </message>
    <message>
        <source>5 of 10</source>
        <translation>10 回中 5 回</translation>
    </message>
    <message>
        <source>how the motor threshold is found</source>
        <translation>運動閾値の求め方</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>muscle and side, as the report shall name it</source>
        <translation>レポートに記載する筋と左右</translation>
    </message>
    <message>
        <source>begins a search for the motor threshold, or goes on with an unfinished one</source>
        <translation>運動閾値の測定を始めるか、途中の測定を続けます</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>takes the last answer back; its pulse can be answered again</source>
        <translation>最後の回答を取り消します。そのパルスにもう一度回答できます</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Next site</source>
        <translation>次の点</translation>
    </message>
    <message>
        <source>a grid of 5 x 5 sites, 10 mm apart at the cortex, round the chosen target</source>
        <translation>選択した標的のまわりの 5 x 5 点の格子。皮質上の間隔は 10 mm</translation>
    </message>
    <message>
        <source>guide to the next site of the grid</source>
        <translation>格子の次の点へ誘導します</translation>
    </message>
    <message>
        <source>guide to the site before</source>
        <translation>前の点へ誘導します</translation>
    </message>
    <message>
        <source>End search</source>
        <translation>測定を終了</translation>
    </message>
    <message>
        <source>Find threshold</source>
        <translation>閾値を測定</translation>
    </message>
    <message>
        <source>End hunt</source>
        <translation>探索を終了</translation>
    </message>
    <message>
        <source>Hunt here</source>
        <translation>ここで探索</translation>
    </message>
</context>
<context>
    <name>facenav::ui::MotorPresenter</name>
    <message>
        <source>not taken: %1 uV is no MEP</source>
        <translation>記録していません: %1 uV は MEP ではありません</translation>
    </message>
    <message>
        <source>the muscle&apos;s answers: one a pulse, while guidance runs</source>
        <translation>筋の反応: 誘導中に 1 パルスにつき 1 回答</translation>
    </message>
    <message>
        <source>Pulse %1%2: did the muscle move?</source>
        <translation>パルス %1%2: 筋は動きましたか?</translation>
    </message>
    <message>
        <source> at %1 %</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source>No pulse to answer for yet: give one first</source>
        <translation>回答するパルスがまだありません: 先に 1 回照射してください</translation>
    </message>
    <message>
        <source>Pulse %1 is answered: give the next one</source>
        <translation>パルス %1 は回答済みです: 次の 1 回を照射してください</translation>
    </message>
    <message>
        <source>no search runs</source>
        <translation>測定は行われていません</translation>
    </message>
    <message>
        <source>THRESHOLD %1</source>
        <translation>閾値 %1</translation>
    </message>
    <message>
        <source>set the output to %1 %, one pulse, then answer
%2</source>
        <translation>出力を %1 % に設定し、1 回照射してから回答してください
%2</translation>
    </message>
    <message>
        <source>site %1 of %2: %3</source>
        <translation>点 %1/%2: %3</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OutputsRow</name>
    <message>
        <source>serve poses</source>
        <translation>姿勢を配信</translation>
    </message>
    <message>
        <source>gives the poses of head and coil to programs on this computer (NaviNIBS, 3D Slicer) by OpenIGTLink, port %1</source>
        <translation>頭とコイルの姿勢を、このコンピューターのプログラム (NaviNIBS、3D Slicer) に OpenIGTLink のポート %1 で渡します</translation>
    </message>
    <message>
        <source>take targets</source>
        <translation>標的を受信</translation>
    </message>
    <message>
        <source>takes from these programs targets (offered, never chosen) and the commands start, stop and pulse</source>
        <translation>これらのプログラムから標的 (候補として示すだけで、選択はしません) と、開始、停止、パルスの命令を受け取ります</translation>
    </message>
    <message>
        <source>send to</source>
        <translation>送信先</translation>
    </message>
    <message>
        <source>sends to the programs named beside it; off at each start</source>
        <translation>横に示すプログラムに送信します。起動のたびにオフになります</translation>
    </message>
    <message>
        <source>outputs with commas between them: %1. Without a host: this computer.</source>
        <translation>出力をコンマで区切ります: %1。ホストの指定なし: このコンピューター。</translation>
    </message>
    <message>
        <source>nobody is connected</source>
        <translation>接続はありません</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OverlayPresenter</name>
    <message>
        <source>Reading the overlays</source>
        <translation>オーバーレイを読み込んでいます</translation>
    </message>
    <message>
        <source>Adding an overlay</source>
        <translation>オーバーレイを追加しています</translation>
    </message>
    <message>
        <source>an overlay is being read; wait a moment</source>
        <translation>オーバーレイを読み込み中です。お待ちください</translation>
    </message>
    <message>
        <source>map</source>
        <translation>マップ</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>マスク</translation>
    </message>
    <message>
        <source>tracts</source>
        <translation>神経線維束</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>MNI</source>
        <translation>MNI</translation>
    </message>
    <message>
        <source>this MRI</source>
        <translation>この MRI</translation>
    </message>
    <message>
        <source>map, %1, from ±%2 to ±%3 %4</source>
        <translation>マップ、%1、±%2〜±%3 %4</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OverlaysPanel</name>
    <message>
        <source>what is shown over the MRI; the mark shows and hides it</source>
        <translation>MRI に重ねて表示するもの。チェックで表示と非表示を切り替えます</translation>
    </message>
    <message>
        <source>opacity, 0 to 100 %</source>
        <translation>不透明度、0〜100 %</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>閾値</translation>
    </message>
    <message>
        <source>values of this size or more are shown, of both signs</source>
        <translation>絶対値がこの値以上のものを、正負とも表示します</translation>
    </message>
    <message>
        <source>colours end at</source>
        <translation>色の上限</translation>
    </message>
    <message>
        <source>the size at which the colours are brightest</source>
        <translation>色が最も明るくなる絶対値</translation>
    </message>
    <message>
        <source>unit of the map&apos;s values: z, t, V/m (Return)</source>
        <translation>マップの値の単位: z、t、V/m (Return)</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルの指定どおり</translation>
    </message>
    <message>
        <source>this MRI</source>
        <translation>この MRI</translation>
    </message>
    <message>
        <source>MNI</source>
        <translation>MNI</translation>
    </message>
    <message>
        <source>the space of the next file: this MRI, or MNI (through the case&apos;s atlas)</source>
        <translation>次のファイルの空間: この MRI、または MNI (症例のアトラスで変換)</translation>
    </message>
    <message>
        <source>Add a file …</source>
        <translation>ファイルを追加 …</translation>
    </message>
    <message>
        <source>NIfTI map or mask, tracts (.trk .tck .trx .vtk), surface (.ply .stl .obj .vtk .vtp); the case keeps a copy</source>
        <translation>NIfTI のマップまたはマスク、神経線維束 (.trk .tck .trx .vtk)、表面 (.ply .stl .obj .vtk .vtp)。症例が複製を保存します</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>remove the chosen overlay and the case&apos;s copy of its file</source>
        <translation>選んだオーバーレイと、症例が持つファイルの複製を削除します</translation>
    </message>
    <message>
        <source>A map, mask, tracts or surface</source>
        <translation>マップ、マスク、神経線維束、表面</translation>
    </message>
    <message>
        <source>Overlays (*.nii *.nii.gz *.hdr *.img *.trk *.tck *.trx *.ply *.stl *.obj *.vtk *.vtp);;All files (*)</source>
        <translation>オーバーレイ (*.nii *.nii.gz *.hdr *.img *.trk *.tck *.trx *.ply *.stl *.obj *.vtk *.vtp);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>読み込んでいます …</translation>
    </message>
    <message>
        <source>no overlay</source>
        <translation>オーバーレイなし</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OverridePanel</name>
    <message>
        <source>your name</source>
        <translation>氏名</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>who decides to treat; kept with the case</source>
        <translation>治療を決定した人。症例に記録されます</translation>
    </message>
    <message>
        <source>why it cannot wait for the sign-off; kept with the case</source>
        <translation>承認を待てない理由。症例に記録されます</translation>
    </message>
    <message>
        <source>Treat nevertheless</source>
        <translation>それでも治療する</translation>
    </message>
    <message>
        <source>recorded with name and reason in the case and in the session&apos;s log</source>
        <translation>氏名と理由とともに、症例とセッションの記録に残ります</translation>
    </message>
    <message>
        <source>!  OVERRIDE (%1): treated on the decision of %2: %3</source>
        <translation>!  例外 (%1): %2 の判断で治療しています: %3</translation>
    </message>
    <message>
        <source>!  %1: this case is not offered for treatment. Have it checked (Prepare, step 4), or give name and reason.</source>
        <translation>!  %1: この症例は治療に使えません。確認を受ける (準備、手順 4) か、氏名と理由を入力してください。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PausePanel</name>
    <message>
        <source>Go on guiding</source>
        <translation>誘導を続ける</translation>
    </message>
    <message>
        <source>ends the pause (Space)</source>
        <translation>一時停止を終えます (Space)</translation>
    </message>
    <message>
        <source>End the session…</source>
        <translation>セッションを終了…</translation>
    </message>
    <message>
        <source>asks for pain and adverse events, then closes the session and shows its report</source>
        <translation>痛みと有害事象を尋ねてからセッションを閉じ、レポートを表示します</translation>
    </message>
    <message>
        <source>The clock holds. Pulses are kept and marked; nobody is guided.</source>
        <translation>時計は止まっています。パルスは印を付けて記録されます。誘導は行いません。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PlacePanel</name>
    <message>
        <source>Crosshair</source>
        <translation>十字線</translation>
    </message>
    <message>
        <source>mm; RAS of the patient&apos;s scan, MNI and labels through the atlas registered to it</source>
        <translation>mm。患者のスキャンの RAS 座標。MNI とラベルは、位置を合わせたアトラスによります</translation>
    </message>
    <message>
        <source>MNI</source>
        <translation>MNI</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>what the typed numbers are</source>
        <translation>入力した数値の座標系</translation>
    </message>
    <message>
        <source>x y z, mm</source>
        <translation>x y z (mm)</translation>
    </message>
    <message>
        <source>type coordinates, such as -38 -22 56 or -38,5; -22; 56; Return: the crosshair goes there (Ctrl+G)</source>
        <translation>座標を入力します。例: -38 -22 56、-38,5; -22; 56。Return: 十字線がそこへ移動します (Ctrl+G)</translation>
    </message>
    <message>
        <source>Target here</source>
        <translation>ここに標的</translation>
    </message>
    <message>
        <source>a target at the cortex under the crosshair (Ctrl+T)</source>
        <translation>十字線の下の皮質に標的を作ります (Ctrl+T)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PlacePresenter</name>
    <message>
        <source>%1 (%2 mm away)</source>
        <translation>%1 (%2 mm の距離)</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>MNI</source>
        <translation>MNI</translation>
    </message>
    <message>
        <source>MNI  the case has no atlas</source>
        <translation>MNI  症例にアトラスがありません</translation>
    </message>
    <message>
        <source>no label within 5 mm</source>
        <translation>5 mm 以内にラベルなし</translation>
    </message>
    <message>
        <source>the case has no atlas: type RAS coordinates</source>
        <translation>症例にアトラスがありません: RAS 座標を入力してください</translation>
    </message>
    <message>
        <source>%1 mm outside the head: check the numbers, and whether they are MNI or RAS</source>
        <translation>頭部から %1 mm 外です: 数値と、MNI か RAS かを確認してください</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PlanPresenter</name>
    <message>
        <source>no target: the place lies %1 mm outside the head; choose one in the head</source>
        <translation>標的なし: その場所は頭部から %1 mm 外です。頭部の中を選んでください</translation>
    </message>
    <message>
        <source>there is a target &apos;%1&apos; already</source>
        <translation>標的 &apos;%1&apos; は既にあります</translation>
    </message>
    <message>
        <source>no brain model: click on the slice where the target lies</source>
        <translation>脳モデルがありません: 断面上で標的の場所をクリックしてください</translation>
    </message>
    <message>
        <source>the target is locked; unlock it first</source>
        <translation>標的がロックされています。先にロックを解除してください</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>標的 %1</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>the case has no atlas, which the other side is found with</source>
        <translation>症例にアトラスがないため、反対側を求められません</translation>
    </message>
    <message>
        <source>no case is open</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, version %2: %3 pulses</source>
        <translation>&apos;%1&apos;、バージョン %2: パルス %3 回</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>a usual figure-of-eight (the case names none)</source>
        <translation>一般的な 8 の字コイル (症例に指定なし)</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>名前なし</translation>
    </message>
    <message>
        <source>handle %1° from %2 (+ to the midline)</source>
        <translation>ハンドル %2から %1° (+ は正中線側)</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>前方</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>上方</translation>
    </message>
    <message>
        <source>the coil passes %1 mm through the skin</source>
        <translation>コイルが皮膚に %1 mm 食い込みます</translation>
    </message>
    <message>
        <source>rests flat on the head</source>
        <translation>頭部に平らに接しています</translation>
    </message>
    <message>
        <source>stands %1 mm over the skin, tilted %2°</source>
        <translation>皮膚から %1 mm 離れ、%2° 傾いています</translation>
    </message>
    <message>
        <source>from &apos;%1&apos;: %2 mm, cortex %3 mm, tilt %4°, twist %5°</source>
        <translation>&apos;%1&apos; から: %2 mm、皮質 %3 mm、傾き %4°、ねじれ %5°</translation>
    </message>
    <message>
        <source>cortex %1 mm below the scalp</source>
        <translation>皮質は頭皮下 %1 mm</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>gap %1 mm</source>
        <translation>隙間 %1 mm</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PlanWorkspace</name>
    <message>
        <source>search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>shows the targets whose name or note holds these words</source>
        <translation>名前またはメモにこの語を含む標的を表示します</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>note of the active target (Return)</source>
        <translation>選択中の標的のメモ (Return)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>mm; the cortex&apos;s depth is measured from the scalp along the coil&apos;s axis; gap: between coil and skin, for hair</source>
        <translation>mm。皮質の深さはコイルの軸に沿って頭皮から測ります。隙間: コイルと皮膚の間 (髪のため)</translation>
    </message>
    <message>
        <source>Click the cortex, or double click a slice, for a target. Arrow keys move it.</source>
        <translation>皮質をクリックするか、断面をダブルクリックすると標的ができます。矢印キーで動かします。</translation>
    </message>
    <message>
        <source>undo the last step of the plan</source>
        <translation>計画の最後の操作を元に戻します</translation>
    </message>
    <message>
        <source>redo the step that was undone</source>
        <translation>元に戻した操作をやり直します</translation>
    </message>
    <message>
        <source>type coordinates to go to</source>
        <translation>移動先の座標を入力します</translation>
    </message>
    <message>
        <source>delete the active target</source>
        <translation>選択中の標的を削除します</translation>
    </message>
    <message>
        <source>move the target by 1 mm</source>
        <translation>標的を 1 mm 動かします</translation>
    </message>
    <message>
        <source>move the target by 5 mm</source>
        <translation>標的を 5 mm 動かします</translation>
    </message>
    <message>
        <source>arrows: move the target by 1 mm, with Shift 5 mm   Ctrl+left, Ctrl+right: turn it by 5°</source>
        <translation>矢印キー: 標的を 1 mm 動かす、Shift で 5 mm   Ctrl+左、Ctrl+右: 5° 回す</translation>
    </message>
    <message>
        <source>no target chosen</source>
        <translation>標的が選ばれていません</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PreparePresenter</name>
    <message>
        <source>NIfTI volume</source>
        <translation>NIfTI ボリューム</translation>
    </message>
    <message>
        <source>as chosen; a file&apos;s own name may be a patient&apos;s and is not shown</source>
        <translation>選択したファイル。ファイル名は患者名の可能性があるため表示しません</translation>
    </message>
    <message>
        <source>Looking for series</source>
        <translation>シリーズを探しています</translation>
    </message>
    <message>
        <source>patient %1</source>
        <translation>患者 %1</translation>
    </message>
    <message>
        <source>(no description)</source>
        <translation>(説明なし)</translation>
    </message>
    <message>
        <source>%1  %2  %3 x %4 x %5  %6 mm  %7</source>
        <translation>%1  %2  %3 x %4 x %5  %6 mm  %7</translation>
    </message>
    <message>
        <source>not usable: %1</source>
        <translation>使用不可: %1</translation>
    </message>
    <message>
        <source>Opening the case</source>
        <translation>症例を開いています</translation>
    </message>
    <message>
        <source>voxels %1 x %2 x %3 mm</source>
        <translation>ボクセル %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>a face to align to</source>
        <translation>位置合わせに使う顔あり</translation>
    </message>
    <message>
        <source>no face to align to</source>
        <translation>位置合わせに使う顔なし</translation>
    </message>
    <message>
        <source>brain %1 ml</source>
        <translation>脳 %1 ml</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PrepareQueue</name>
    <message>
        <source>(no description)</source>
        <translation>(説明なし)</translation>
    </message>
    <message>
        <source>images of %1 patients</source>
        <translation>患者 %1 人の画像</translation>
    </message>
    <message>
        <source>slices that can be read in several ways</source>
        <translation>複数の読み方ができる断面</translation>
    </message>
    <message>
        <source>no series is recommended</source>
        <translation>推奨できるシリーズがありません</translation>
    </message>
    <message>
        <source>volume %1, %2</source>
        <translation>ボリューム %1、%2</translation>
    </message>
    <message>
        <source>folder %1, %2</source>
        <translation>フォルダー %1、%2</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>準備しています</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, longer than the last one</source>
        <translation>%1、前回より長くかかっています</translation>
    </message>
    <message>
        <source>%1, about %2 s left</source>
        <translation>%1、残り約 %2 s</translation>
    </message>
    <message>
        <source>preparing 1</source>
        <translation>準備中 1</translation>
    </message>
    <message>
        <source>%1 waiting for the treatment&apos;s end</source>
        <translation>治療の終了待ち %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>待機中 %1</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>失敗 %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PrepareWorkspace</name>
    <message>
        <source>cases and what is being prepared (Alt+1)</source>
        <translation>症例と、準備中のもの (Alt+1)</translation>
    </message>
    <message>
        <source>series of a folder (Alt+2)</source>
        <translation>フォルダーのシリーズ (Alt+2)</translation>
    </message>
    <message>
        <source>slices with contours, findings (Alt+3)</source>
        <translation>輪郭付きの断面、所見 (Alt+3)</translation>
    </message>
    <message>
        <source>take the model as seen, by name (Alt+4)</source>
        <translation>確認したモデルを記名して承認します (Alt+4)</translation>
    </message>
    <message>
        <source>1  Worklist</source>
        <translation>1  ワークリスト</translation>
    </message>
    <message>
        <source>2  Series</source>
        <translation>2  シリーズ</translation>
    </message>
    <message>
        <source>3  Check &amp;&amp; edit</source>
        <translation>3  確認と修正</translation>
    </message>
    <message>
        <source>4  Sign off</source>
        <translation>4  承認</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ProjectorCodeScreen</name>
    <message>
        <source>FaceNav: calibration of the projector</source>
        <translation>FaceNav: プロジェクターの較正</translation>
    </message>
    <message>
        <source>Space: take a scene. Escape: keep what there is.</source>
        <translation>Space: シーンを撮影。Escape: 撮影済みのものを使用。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ProjectorScreen</name>
    <message>
        <source>FaceNav: projector</source>
        <translation>FaceNav: プロジェクター</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PulseRow</name>
    <message>
        <source>; and %1 more</source>
        <translation>; ほか %1 件</translation>
    </message>
    <message>
        <source>pulse %1: on target</source>
        <translation>パルス %1: 標的上</translation>
    </message>
    <message>
        <source>OUTSIDE</source>
        <translation>範囲外</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>追跡喪失</translation>
    </message>
    <message>
        <source>%1 PULSE %2 %3: %4</source>
        <translation>%1 パルス %2 %3: %4</translation>
    </message>
    <message>
        <source>time since guidance was started, without pauses</source>
        <translation>誘導を開始してからの時間 (一時停止を除く)</translation>
    </message>
    <message>
        <source>Pulse given</source>
        <translation>照射を記録</translation>
    </message>
    <message>
        <source>counts a TMS pulse and keeps where the coil was (P)</source>
        <translation>TMS パルスを 1 回数え、そのときのコイルの位置を記録します (P)</translation>
    </message>
    <message>
        <source>NOT LOGGED: %1</source>
        <translation>記録されていません: %1</translation>
    </message>
    <message>
        <source>no session</source>
        <translation>セッションなし</translation>
    </message>
    <message>
        <source>pulses %1</source>
        <translation>パルス %1</translation>
    </message>
    <message>
        <source>/%1</source>
        <translation>/%1</translation>
    </message>
    <message>
        <source>%1 on target</source>
        <translation>標的上 %1</translation>
    </message>
    <message>
        <source>, %1 outside</source>
        <translation>、範囲外 %1</translation>
    </message>
    <message>
        <source>, %1 lost</source>
        <translation>、追跡喪失 %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PulseTable</name>
    <message>
        <source>strongest at RAS %1 %2 %3 mm; tier %4, coil %5</source>
        <translation>最強点 RAS %1 %2 %3 mm; 段階 %4、コイル %5</translation>
    </message>
    <message>
        <source>✕ excluded</source>
        <translation>✕ 除外</translation>
    </message>
    <message>
        <source>● on target</source>
        <translation>● 標的上</translation>
    </message>
    <message>
        <source>□ outside</source>
        <translation>□ 範囲外</translation>
    </message>
    <message>
        <source>– lost</source>
        <translation>– 追跡喪失</translation>
    </message>
    <message>
        <source>entered after the pulse; double click to type another</source>
        <translation>照射後に入力した値。ダブルクリックで入力し直せます</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>target</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
</context>
<context>
    <name>facenav::ui::PulsesPage</name>
    <message>
        <source>the number by which the pulses are coloured and plotted</source>
        <translation>パルスの色分けとグラフに使う値</translation>
    </message>
    <message>
        <source>MEP map</source>
        <translation>MEP マップ</translation>
    </message>
    <message>
        <source>the MEPs, smoothed over the brain&apos;s surface, in place of the pulses</source>
        <translation>パルスに代えて、MEP を脳の表面で平滑化して示します</translation>
    </message>
    <message>
        <source>by field</source>
        <translation>電場による</translation>
    </message>
    <message>
        <source>which place of the cortex explains the MEPs, by the electric field of each pulse there: R2 of the MEPs on the field; coil as in Plan; what it means: the manual&apos;s page &apos;Field&apos;</source>
        <translation>皮質のどの場所が MEP を説明するか: 各パルスのその場所での電場に対する MEP の R2。コイルは計画のもの。意味: マニュアルの「Field」のページ</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>皮膚</translation>
    </message>
    <message>
        <source>shows the scalp over the brain</source>
        <translation>脳の上に頭皮を表示します</translation>
    </message>
    <message>
        <source>no pulse has: %1</source>
        <translation>この値を持つパルスなし: %1</translation>
    </message>
    <message>
        <source>R² of the MEPs on the field</source>
        <translation>電場に対する MEP の R²</translation>
    </message>
    <message>
        <source>MEP</source>
        <translation>MEP</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReplayPage</name>
    <message>
        <source>left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>as guidance.csv holds them for this frame</source>
        <translation>このフレームについて guidance.csv に記録された値</translation>
    </message>
    <message>
        <source>◀|</source>
        <translation>◀|</translation>
    </message>
    <message>
        <source>one frame back (Left; with Shift: %1)</source>
        <translation>1 フレーム戻る (Left。Shift を押すと: %1)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>play and pause, as fast as it was (Space)</source>
        <translation>実際の速さで再生、一時停止 (Space)</translation>
    </message>
    <message>
        <source>|▶</source>
        <translation>|▶</translation>
    </message>
    <message>
        <source>one frame on (Right; with Shift: %1)</source>
        <translation>1 フレーム進む (Right。Shift を押すと: %1)</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>追跡結果…</translation>
    </message>
    <message>
        <source>another folder with poses.csv, as `facenav track` writes it</source>
        <translation>`facenav track` が書き出す poses.csv のある別のフォルダー</translation>
    </message>
    <message>
        <source>Folder with poses.csv</source>
        <translation>poses.csv のあるフォルダー</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>重ね描き</translation>
    </message>
    <message>
        <source>the scalp, the coil and the target drawn into the pictures, where the poses of this frame put them (O)</source>
        <translation>このフレームの姿勢に基づいて、頭皮、コイル、標的を画像に描きます (O)</translation>
    </message>
    <message>
        <source>Pictures…</source>
        <translation>画像…</translation>
    </message>
    <message>
        <source>the folder of the session&apos;s recording, if it is elsewhere</source>
        <translation>セッションの記録が別の場所にある場合のフォルダー</translation>
    </message>
    <message>
        <source>Recording of this session</source>
        <translation>このセッションの記録</translation>
    </message>
    <message>
        <source>one frame back</source>
        <translation>1 フレーム戻る</translation>
    </message>
    <message>
        <source>one frame on</source>
        <translation>1 フレーム進む</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>%1 フレーム戻る</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>%1 フレーム進む</translation>
    </message>
    <message>
        <source>play and pause</source>
        <translation>再生、一時停止</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>LOST: %1</source>
        <translation>追跡喪失: %1</translation>
    </message>
    <message>
        <source>reading the picture</source>
        <translation>画像を読み込んでいます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReplayPresenter</name>
    <message>
        <source>reading the poses</source>
        <translation>姿勢を読み込んでいます</translation>
    </message>
    <message>
        <source>%1 of %2, frame %3</source>
        <translation>%1 / %2、フレーム %3</translation>
    </message>
    <message>
        <source>alignment: 95 % within %1 mm</source>
        <translation>位置合わせ: 95 % が %1 mm 以内</translation>
    </message>
    <message>
        <source>error %1 mm, sideways %2 mm, depth %3 mm</source>
        <translation>誤差 %1 mm、横ずれ %2 mm、深さ %3 mm</translation>
    </message>
    <message>
        <source>tilt %1°, twist %2°, beam misses by %3 mm</source>
        <translation>傾き %1°、ねじれ %2°、ビームのずれ %3 mm</translation>
    </message>
    <message>
        <source>Reading a picture</source>
        <translation>画像を読み込んでいます</translation>
    </message>
    <message>
        <source>no picture was kept of this frame</source>
        <translation>このフレームの画像は保存されていません</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>記録を読み込んでいます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReportPage</name>
    <message>
        <source>report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>This case has no sessions yet.</source>
        <translation>この症例にはまだセッションがありません。</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>セッションを読み込んでいます</translation>
    </message>
    <message>
        <source>the report is being made</source>
        <translation>レポートを作成しています</translation>
    </message>
    <message>
        <source>Making the report</source>
        <translation>レポートを作成しています</translation>
    </message>
    <message>
        <source>Write PDF keeps this as report.pdf and report.html, with pictures of the pulses, and pulses.csv.</source>
        <translation>「PDF を書き出す」で、パルスの図を含む report.pdf と report.html、および pulses.csv として保存します。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReturnPanel</name>
    <message>
        <source>Go on with it</source>
        <translation>このセッションを続ける</translation>
    </message>
    <message>
        <source>keeps counting in the same session, on its own alignment; guidance comes when two seconds of measuring have shown that the face still fits it</source>
        <translation>同じセッション、同じ位置合わせのまま数え続けます。2 秒間の計測で顔が今も合っていることを確認してから、誘導を表示します</translation>
    </message>
    <message>
        <source>Begin a new one</source>
        <translation>新しいセッション</translation>
    </message>
    <message>
        <source>leaves that session as it is; align, and start guidance</source>
        <translation>前のセッションはそのままにします。位置合わせを行い、誘導を開始してください</translation>
    </message>
    <message>
        <source> To go on: %1.</source>
        <translation> 続けるには: %1。</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReturnPresenter</name>
    <message>
        <source>less than a minute ago</source>
        <translation>1 分以内</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 分前</translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation>%1 時間前</translation>
    </message>
    <message>
        <source>%1 of %2 pulses are kept</source>
        <translation>%2 パルス中 %1 が記録されています</translation>
    </message>
    <message>
        <source>1 pulse is kept</source>
        <translation>1 パルスが記録されています</translation>
    </message>
    <message>
        <source>%1 pulses are kept</source>
        <translation>%1 パルスが記録されています</translation>
    </message>
    <message>
        <source>, target %1</source>
        <translation>、標的 %1</translation>
    </message>
    <message>
        <source>The session of %1 was ended %2 before its plan was given: %3.</source>
        <translation>%1 のセッションは、計画のパルスを終える前に終了しました (%2): %3。</translation>
    </message>
    <message>
        <source>The session of %1 was cut off %2: %3.</source>
        <translation>%1 のセッションは途中で切れました (%2): %3。</translation>
    </message>
    <message>
        <source>the case is not signed off</source>
        <translation>症例が承認されていません</translation>
    </message>
    <message>
        <source>open the cameras first (step 1)</source>
        <translation>先にカメラを開いてください (手順 1)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReviewPresenter</name>
    <message>
        <source>Reading the sessions</source>
        <translation>セッションを読み込んでいます</translation>
    </message>
    <message>
        <source>Reading the session</source>
        <translation>セッションを読み込んでいます</translation>
    </message>
    <message>
        <source>report.pdf, report.html and pulses.csv are in %1</source>
        <translation>report.pdf、report.html、pulses.csv は %1 にあります</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ReviewWorkspace</name>
    <message>
        <source>Pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>pulses on cortex and scalp, charts (Alt+1)</source>
        <translation>皮質と頭皮上のパルス、グラフ (Alt+1)</translation>
    </message>
    <message>
        <source>the session frame by frame (Alt+2)</source>
        <translation>セッションをフレームごとに表示 (Alt+2)</translation>
    </message>
    <message>
        <source>against another session (Alt+3)</source>
        <translation>別のセッションとの比較 (Alt+3)</translation>
    </message>
    <message>
        <source>the report, to read (Alt+4)</source>
        <translation>レポートを読む (Alt+4)</translation>
    </message>
    <message>
        <source>with label</source>
        <translation>ラベルを含める</translation>
    </message>
    <message>
        <source>adds the case&apos;s label, which may be the patient&apos;s name, to the report</source>
        <translation>症例のラベル (患者名の可能性があります) をレポートに加えます</translation>
    </message>
    <message>
        <source>Write PDF</source>
        <translation>PDF を書き出す</translation>
    </message>
    <message>
        <source>writes report.pdf, report.html and pulses.csv into the session&apos;s folder</source>
        <translation>report.pdf、report.html、pulses.csv をセッションのフォルダーに書き出します</translation>
    </message>
    <message>
        <source>From home…</source>
        <translation>在宅から…</translation>
    </message>
    <message>
        <source>add the file that a session at home sent back</source>
        <translation>在宅のセッションから返送されたファイルを加えます</translation>
    </message>
    <message>
        <source>MEPs…</source>
        <translation>MEP…</translation>
    </message>
    <message>
        <source>import from a CSV file with utc or t_s, and mep_uv, or from an XDF recording with markers and EMG; each goes to the pulse at its time</source>
        <translation>utc または t_s と mep_uv を含む CSV ファイル、またはマーカーと EMG を含む XDF 記録から取り込みます。それぞれ時刻の合うパルスに割り当てます</translation>
    </message>
    <message>
        <source>The file that came back from home</source>
        <translation>在宅から返送されたファイル</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>MEPs by time</source>
        <translation>時刻による MEP</translation>
    </message>
    <message>
        <source>CSV, or XDF of LabRecorder (*.csv *.xdf)</source>
        <translation>CSV、または LabRecorder の XDF (*.csv *.xdf)</translation>
    </message>
    <message>
        <source>EMG and markers</source>
        <translation>EMG とマーカー</translation>
    </message>
    <message>
        <source>STREAM:CHANNEL of the EMG; STREAM:MARKER of the pulses; uV or mV. Empty: find them</source>
        <translation>EMG の STREAM:CHANNEL; パルスの STREAM:MARKER; uV または mV。空欄: 自動で探します</translation>
    </message>
    <message>
        <source>Offset of the clocks</source>
        <translation>時計のずれ</translation>
    </message>
    <message>
        <source>Seconds from the file&apos;s clock to the session&apos;s; empty: find it</source>
        <translation>ファイルの時計からセッションの時計までの秒数。空欄: 自動で求めます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SceneView</name>
    <message>
        <source>left: rotate   middle: pan   right: zoom   click: choose a point   right click: menu</source>
        <translation>左: 回転   中央: 移動   右: 拡大縮小   クリック: 点を選択   右クリック: メニュー</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ScreensRow</name>
    <message>
        <source>Second screen</source>
        <translation>第 2 画面</translation>
    </message>
    <message>
        <source>guidance alone, to be read at three metres, on another screen where there is one (F8)</source>
        <translation>誘導だけを、3 m 離れて読める大きさで、別の画面があればそこに表示します (F8)</translation>
    </message>
    <message>
        <source>Projector</source>
        <translation>プロジェクター</translation>
    </message>
    <message>
        <source>outline, ring and arrow on the head, by a calibrated projector (projector.yml); it must show the window&apos;s picture unscaled (Shift+F8)</source>
        <translation>較正済みのプロジェクター (projector.yml) で、輪郭、輪、矢印を頭に投影します。プロジェクターはウィンドウの画像を等倍で表示する必要があります (Shift+F8)</translation>
    </message>
    <message>
        <source>The projector&apos;s calibration</source>
        <translation>プロジェクターの較正</translation>
    </message>
    <message>
        <source>projector.yml (*.yml)</source>
        <translation>projector.yml (*.yml)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SecondCoilRow</name>
    <message>
        <source>second coil</source>
        <translation>第 2 コイル</translation>
    </message>
    <message>
        <source>a second coil with a marker of its own, followed in the next session</source>
        <translation>固有のマーカーを持つ第 2 コイル。次のセッションで追跡します</translation>
    </message>
    <message>
        <source>the second coil&apos;s target</source>
        <translation>第 2 コイルの標的</translation>
    </message>
    <message>
        <source>the second coil&apos;s own target</source>
        <translation>第 2 コイル固有の標的</translation>
    </message>
    <message>
        <source>coil of the pulses</source>
        <translation>照射するコイル</translation>
    </message>
    <message>
        <source>which of both coils gives the pulses of the next session</source>
        <translation>次のセッションで照射するコイル</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>no target</source>
        <translation>標的なし</translation>
    </message>
    <message>
        <source>pulses of?</source>
        <translation>照射は?</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SeriesPage</name>
    <message>
        <source>Read DICOM folder…</source>
        <translation>DICOM フォルダーを読み込む…</translation>
    </message>
    <message>
        <source>Read NIfTI file…</source>
        <translation>NIfTI ファイルを読み込む…</translation>
    </message>
    <message>
        <source>list the series under a folder (Ctrl+I); or drop a folder anywhere</source>
        <translation>フォルダー内のシリーズを一覧します (Ctrl+I)。フォルダーをどこかにドロップしてもかまいません</translation>
    </message>
    <message>
        <source>a T1 of the whole head; or drop the file anywhere</source>
        <translation>頭部全体の T1。ファイルをどこかにドロップしてもかまいません</translation>
    </message>
    <message>
        <source>From the archive…</source>
        <translation>アーカイブから…</translation>
    </message>
    <message>
        <source>find and fetch a series of the hospital&apos;s PACS (Ctrl+Shift+A)</source>
        <translation>院内の PACS からシリーズを検索して取得します (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>or drop it anywhere in the window</source>
        <translation>ウィンドウのどこかにドロップしてもかまいません</translation>
    </message>
    <message>
        <source>show patients</source>
        <translation>患者を表示</translation>
    </message>
    <message>
        <source>name, birth date and ID from the files (Ctrl+P)</source>
        <translation>ファイル内の氏名、生年月日、ID (Ctrl+P)</translation>
    </message>
    <message>
        <source>series</source>
        <translation>シリーズ</translation>
    </message>
    <message>
        <source>Prepare the chosen series</source>
        <translation>選んだシリーズを準備</translation>
    </message>
    <message>
        <source>model skin and brain; goes into the worklist&apos;s queue (Ctrl+Return)</source>
        <translation>皮膚と脳のモデルを作ります。ワークリストの待ち行列に入ります (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Read DICOM folder</source>
        <translation>DICOM フォルダーを読み込む</translation>
    </message>
    <message>
        <source>Read NIfTI</source>
        <translation>NIfTI を読み込む</translation>
    </message>
    <message>
        <source>NIfTI (%1)</source>
        <translation>NIfTI (%1)</translation>
    </message>
    <message>
        <source>nothing found</source>
        <translation>何も見つかりません</translation>
    </message>
    <message>
        <source>series found: %1</source>
        <translation>見つかったシリーズ: %1</translation>
    </message>
    <message>
        <source>★ recommended: </source>
        <translation>★ 推奨: </translation>
    </message>
    <message>
        <source>✕ </source>
        <translation>✕ </translation>
    </message>
</context>
<context>
    <name>facenav::ui::SessionPanel</name>
    <message>
        <source>a pause or its end, with the time, in the session&apos;s log</source>
        <translation>一時停止またはその終わりを、時刻とともにセッションの記録に残します</translation>
    </message>
    <message>
        <source>patient asked</source>
        <translation>患者の希望</translation>
    </message>
    <message>
        <source>coil too warm</source>
        <translation>コイルの過熱</translation>
    </message>
    <message>
        <source>position lost</source>
        <translation>位置ずれ</translation>
    </message>
    <message>
        <source>equipment</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>why the treatment is paused</source>
        <translation>治療を一時停止する理由</translation>
    </message>
    <message>
        <source>0: none, 10: the worst imaginable; kept in the session&apos;s log</source>
        <translation>0: なし、10: 想像しうる最悪の痛み。セッションの記録に残ります</translation>
    </message>
    <message>
        <source>pain before</source>
        <translation>開始前の痛み</translation>
    </message>
    <message>
        <source>after</source>
        <translation>終了後</translation>
    </message>
    <message>
        <source>adverse event</source>
        <translation>有害事象</translation>
    </message>
    <message>
        <source>what happened, in words; kept in the session&apos;s log and report</source>
        <translation>起きたこと (文章で)。セッションの記録とレポートに残ります</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>keeps it with the time (Enter)</source>
        <translation>時刻とともに記録します (Enter)</translation>
    </message>
    <message>
        <source>pulses: keyboard alone</source>
        <translation>パルス: キーボードのみ</translation>
    </message>
    <message>
        <source>where pulses come from beside the key P: %1. It only listens; nothing is fired.</source>
        <translation>P キーのほかにパルスを受け取る先: %1。受信するだけで、照射はしません。</translation>
    </message>
    <message>
        <source>pulses from</source>
        <translation>パルスの入力元</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>falling: lost; one tone: near the target; rising: on target; click: a pulse</source>
        <translation>下降音: 追跡喪失。単音: 標的の近く。上昇音: 標的上。クリック音: パルス</translation>
    </message>
    <message>
        <source>volume of the tones</source>
        <translation>音量</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>no sound on this machine</source>
        <translation>このコンピューターに音声出力がありません</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SessionsPanel</name>
    <message>
        <source>session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>on</source>
        <translation>標的上</translation>
    </message>
    <message>
        <source>error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>喪失</translation>
    </message>
    <message>
        <source>off</source>
        <translation>逸脱</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>start of the session</source>
        <translation>セッションの開始</translation>
    </message>
    <message>
        <source>all pulses; in brackets: excluded</source>
        <translation>すべてのパルス。括弧内: 除外</translation>
    </message>
    <message>
        <source>pulses within the tolerance, of those that are not excluded</source>
        <translation>除外していないパルスのうち、許容範囲内の割合</translation>
    </message>
    <message>
        <source>distance of coil and target at the pulses, median / 95th percentile, mm</source>
        <translation>照射時のコイルと標的の距離、中央値 / 95 パーセンタイル (mm)</translation>
    </message>
    <message>
        <source>time with face or coil lost, min:s</source>
        <translation>顔またはコイルの追跡を失っていた時間 (分:秒)</translation>
    </message>
    <message>
        <source>time outside the tolerance, with losses, min:s</source>
        <translation>許容範囲外の時間 (追跡喪失を含む、分:秒)</translation>
    </message>
    <message>
        <source>error of the alignment at the target: 95 % of such alignments are within, mm</source>
        <translation>標的での位置合わせの誤差: このような位置合わせの 95 % がこの範囲に収まります (mm)</translation>
    </message>
    <message>
        <source>sessions</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>click a heading to sort; double click an MEP to type it</source>
        <translation>見出しをクリック: 並べ替え。MEP をダブルクリック: 入力</translation>
    </message>
    <message>
        <source>Exclude…</source>
        <translation>除外…</translation>
    </message>
    <message>
        <source>Exclude %1 pulses…</source>
        <translation>%1 パルスを除外…</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>除外を解除</translation>
    </message>
    <message>
        <source>Take in %1 pulses</source>
        <translation>%1 パルスの除外を解除</translation>
    </message>
    <message>
        <source>Type its MEP…</source>
        <translation>MEP を入力…</translation>
    </message>
    <message>
        <source>Show in the replay</source>
        <translation>再生で表示</translation>
    </message>
    <message>
        <source>Exclude pulses</source>
        <translation>パルスを除外</translation>
    </message>
    <message>
        <source>Reason to exclude the chosen pulses. They count no more; nothing is deleted.</source>
        <translation>選択したパルスを除外する理由。以後は数えませんが、何も削除されません。</translation>
    </message>
    <message>
        <source>reason to exclude</source>
        <translation>除外の理由</translation>
    </message>
    <message>
        <source>why the chosen pulses do not count; kept with the change</source>
        <translation>選択したパルスを数えない理由。変更とともに記録されます</translation>
    </message>
    <message>
        <source>by</source>
        <translation>記入者</translation>
    </message>
    <message>
        <source>your name or initials; kept with the change</source>
        <translation>氏名またはイニシャル。変更とともに記録されます</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>they count no more; nothing is deleted</source>
        <translation>以後は数えませんが、何も削除されません</translation>
    </message>
    <message>
        <source>they count again</source>
        <translation>再び数えます</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>undo a change to the pulses</source>
        <translation>パルスの変更を元に戻します</translation>
    </message>
    <message>
        <source>redo a change to the pulses</source>
        <translation>パルスの変更をやり直します</translation>
    </message>
    <message>
        <source>%1 home</source>
        <translation>%1 在宅</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>This case has no sessions yet: treat it first.</source>
        <translation>この症例にはまだセッションがありません: 先に治療を行ってください。</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>セッションを読み込んでいます</translation>
    </message>
    <message>
        <source>at home</source>
        <translation>在宅</translation>
    </message>
    <message>
        <source>caution: %1</source>
        <translation>注意: %1</translation>
    </message>
    <message>
        <source>losses: face %1, coil %2</source>
        <translation>追跡喪失: 顔 %1 回、コイル %2 回</translation>
    </message>
    <message>
        <source>adverse events: %1</source>
        <translation>有害事象: %1</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Shift+Z)</source>
        <translation>%1 (Ctrl+Shift+Z)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SetupPresenter</name>
    <message>
        <source>Looking for cameras</source>
        <translation>カメラを探しています</translation>
    </message>
    <message>
        <source>the cameras are not open: see what is written below the fields</source>
        <translation>カメラが開かれていません: 入力欄の下の説明を見てください</translation>
    </message>
    <message>
        <source>open the cameras</source>
        <translation>カメラを開いてください</translation>
    </message>
    <message>
        <source>these cameras cannot be opened: see what is written below the fields</source>
        <translation>これらのカメラは開けません: 入力欄の下の説明を見てください</translation>
    </message>
    <message>
        <source>choose the left and the right camera, and open them</source>
        <translation>左カメラと右カメラを選び、開いてください</translation>
    </message>
    <message>
        <source>; or type the address of a stream, a video or a folder of pictures</source>
        <translation>; またはストリーム、動画、画像フォルダーのアドレスを入力してください</translation>
    </message>
    <message>
        <source>type width x height, as 1280x720</source>
        <translation>幅 x 高さを入力してください。例: 1280x720</translation>
    </message>
    <message>
        <source>this is the left camera: choose another</source>
        <translation>これは左カメラです: 別のものを選んでください</translation>
    </message>
    <message>
        <source>Opening the cameras: they adjust to the light</source>
        <translation>カメラを開いています: 明るさに順応しています</translation>
    </message>
    <message>
        <source>there is no rig called %1 that knows its cameras</source>
        <translation>カメラの分かっている %1 というカメラ構成はありません</translation>
    </message>
    <message>
        <source>Opening the cameras</source>
        <translation>カメラを開いています</translation>
    </message>
    <message>
        <source>room 1</source>
        <translation>room 1</translation>
    </message>
    <message>
        <source>waiting for the first picture</source>
        <translation>最初の画像を待っています</translation>
    </message>
    <message>
        <source>: keep it under a name</source>
        <translation>: 名前を付けて保存してください</translation>
    </message>
    <message>
        <source>; kept with the pair</source>
        <translation>; カメラペアとともに保存済み</translation>
    </message>
    <message>
        <source>±%1 mm at %2 mm</source>
        <translation>±%1 mm (距離 %2 mm)</translation>
    </message>
    <message>
        <source>the calibration is kept once its check holds</source>
        <translation>較正は、点検に合格すると保存されます</translation>
    </message>
    <message>
        <source>the coil is not calibrated yet</source>
        <translation>コイルはまだ較正されていません</translation>
    </message>
    <message>
        <source>choose the coil from the library first (facenav coil add)</source>
        <translation>先にライブラリからコイルを選んでください (facenav coil add)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SetupTools</name>
    <message>
        <source>Open the cameras</source>
        <translation>カメラを開く</translation>
    </message>
    <message>
        <source>they adjust to the light, then they are locked</source>
        <translation>明るさに順応してから、設定を固定します</translation>
    </message>
    <message>
        <source>Swap left and right</source>
        <translation>左右を入れ替え</translation>
    </message>
    <message>
        <source>if the pictures are on the wrong sides</source>
        <translation>画像の左右が逆の場合</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>再検索</translation>
    </message>
    <message>
        <source>which cameras are plugged in</source>
        <translation>接続されているカメラを調べます</translation>
    </message>
    <message>
        <source>Or a pair that is kept</source>
        <translation>または保存済みのペア</translation>
    </message>
    <message>
        <source>it is checked again, and repaired if it was moved</source>
        <translation>もう一度点検し、動かされていれば修復します</translation>
    </message>
    <message>
        <source>Check this pair</source>
        <translation>このペアを点検</translation>
    </message>
    <message>
        <source>opens its cameras at step 3</source>
        <translation>手順 3 でカメラを開きます</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>inner corners along the board: one less than squares</source>
        <translation>ボードの横方向の内側の角の数: マスの数より 1 少ない</translation>
    </message>
    <message>
        <source>inner corners down the board: one less than squares</source>
        <translation>ボードの縦方向の内側の角の数: マスの数より 1 少ない</translation>
    </message>
    <message>
        <source>measure ten squares with a ruler, and divide by ten</source>
        <translation>10 マス分を定規で測り、10 で割ってください</translation>
    </message>
    <message>
        <source>corners across</source>
        <translation>横の角の数</translation>
    </message>
    <message>
        <source>corners down</source>
        <translation>縦の角の数</translation>
    </message>
    <message>
        <source>one square</source>
        <translation>1 マス</translation>
    </message>
    <message>
        <source>Print the board…</source>
        <translation>ボードを印刷…</translation>
    </message>
    <message>
        <source>a page (SVG, A4) to print at 100 %</source>
        <translation>1 ページ (SVG、A4)。100 % で印刷してください</translation>
    </message>
    <message>
        <source>Show it on a screen</source>
        <translation>画面に表示</translation>
    </message>
    <message>
        <source>on the second screen or a tablet</source>
        <translation>第 2 画面またはタブレットに表示します</translation>
    </message>
    <message>
        <source>Calculate now</source>
        <translation>今すぐ計算</translation>
    </message>
    <message>
        <source>from 8 views on; by itself when they are enough</source>
        <translation>8 視点以上で可能。十分になると自動で計算します</translation>
    </message>
    <message>
        <source>Take more views</source>
        <translation>視点を追加</translation>
    </message>
    <message>
        <source>beside those that are there</source>
        <translation>既にあるものに加えて撮影します</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>forgets the views</source>
        <translation>撮影した視点を破棄します</translation>
    </message>
    <message>
        <source>Name of this pair</source>
        <translation>このペアの名前</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>cameras, settings, calibration and this check</source>
        <translation>カメラ、設定、較正、この点検結果</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>もう一度点検</translation>
    </message>
    <message>
        <source>with the board in another place</source>
        <translation>ボードを別の場所に置いて点検します</translation>
    </message>
    <message>
        <source>Repair: calibrate again</source>
        <translation>修復: 再較正</translation>
    </message>
    <message>
        <source>two minutes, with the board</source>
        <translation>ボードを使って 2 分</translation>
    </message>
    <message>
        <source>Coil of the library</source>
        <translation>ライブラリのコイル</translation>
    </message>
    <message>
        <source>facenav coil add puts a coil into the library</source>
        <translation>facenav coil add でコイルをライブラリに加えます</translation>
    </message>
    <message>
        <source>Calibrate by pivoting</source>
        <translation>ピボットで較正</translation>
    </message>
    <message>
        <source>three points of the coil on a fixed tip</source>
        <translation>固定した先端にコイルの 3 点を当てます</translation>
    </message>
    <message>
        <source>Calibrate with a jig…</source>
        <translation>治具で較正…</translation>
    </message>
    <message>
        <source>the jig&apos;s marker as coil.json</source>
        <translation>治具のマーカー (coil.json)</translation>
    </message>
    <message>
        <source>Keep the coil</source>
        <translation>コイルを保存</translation>
    </message>
    <message>
        <source>its calibration, in the library</source>
        <translation>較正をライブラリに保存します</translation>
    </message>
    <message>
        <source>Ordinary webcams</source>
        <translation>一般のウェブカメラ</translation>
    </message>
    <message>
        <source>Measure the shutter</source>
        <translation>シャッターを測定</translation>
    </message>
    <message>
        <source>wave the coil quickly before the cameras for some seconds; else the first session with a quick coil measures it</source>
        <translation>カメラの前でコイルを数秒間すばやく振ってください。行わない場合は、コイルがすばやく動いた最初のセッションで測定します</translation>
    </message>
    <message>
        <source>kept: %1</source>
        <translation>保存しました: %1</translation>
    </message>
    <message>
        <source>60 mm, 4x4_50, id 7</source>
        <translation>60 mm、4x4_50、id 7</translation>
    </message>
    <message>
        <source>Open them again</source>
        <translation>開き直す</translation>
    </message>
    <message>
        <source>%1 views taken</source>
        <translation>%1 視点を撮影</translation>
    </message>
    <message>
        <source>kept as %1; go on to the coil, or close</source>
        <translation>%1 として保存しました。コイルへ進むか、閉じてください</translation>
    </message>
    <message>
        <source>Keep the pair</source>
        <translation>ペアを保存</translation>
    </message>
    <message>
        <source>There is a pair called %1. Replace it?</source>
        <translation>%1 というペアは既にあります。置き換えますか?</translation>
    </message>
    <message>
        <source>The board as a page</source>
        <translation>ボードのページ</translation>
    </message>
    <message>
        <source>Page (*.svg)</source>
        <translation>ページ (*.svg)</translation>
    </message>
    <message>
        <source>The jig</source>
        <translation>治具</translation>
    </message>
    <message>
        <source>coil.json (*.json)</source>
        <translation>coil.json (*.json)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SetupWindow</name>
    <message>
        <source>FaceNav: set up the cameras</source>
        <translation>FaceNav: カメラの設定</translation>
    </message>
    <message>
        <source>left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
    <message>
        <source>1  Place</source>
        <translation>1  設置</translation>
    </message>
    <message>
        <source>2  Calibrate</source>
        <translation>2  較正</translation>
    </message>
    <message>
        <source>3  Check</source>
        <translation>3  点検</translation>
    </message>
    <message>
        <source>4  Coil</source>
        <translation>4  コイル</translation>
    </message>
    <message>
        <source>please wait: the cameras are opened</source>
        <translation>お待ちください: カメラを開いています</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ShownTools</name>
    <message>
        <source>Overlays</source>
        <translation>オーバーレイ</translation>
    </message>
    <message>
        <source>maps, masks, tracts and surfaces of other programs over the MRI</source>
        <translation>ほかのプログラムのマップ、マスク、神経線維束、表面を MRI に重ねます</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>the electric field that the planned coil induces in the brain</source>
        <translation>計画したコイルが脳に誘導する電場</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>刺激量</translation>
    </message>
    <message>
        <source>protocol, pulses of the target, and the coil</source>
        <translation>プロトコル、標的のパルス、コイル</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>the MRI along the axis of the target&apos;s coil, along and across its handle (M)</source>
        <translation>標的のコイル軸に沿った MRI (ハンドル方向と横断方向) (M)</translation>
    </message>
    <message>
        <source>EEG</source>
        <translation>脳波</translation>
    </message>
    <message>
        <source>the sites of the 10-20 system on the scalp</source>
        <translation>頭皮上の 10-20 法の電極位置</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SignOffPage</name>
    <message>
        <source>Seen, each by itself</source>
        <translation>それぞれを見て確認</translation>
    </message>
    <message>
        <source>tick each when you have looked at it (arrows, Space)</source>
        <translation>見て確認したものに 1 つずつチェックを入れてください (矢印キー、Space)</translation>
    </message>
    <message>
        <source>what must be seen</source>
        <translation>見て確認する項目</translation>
    </message>
    <message>
        <source>your name or initials</source>
        <translation>氏名またはイニシャル</translation>
    </message>
    <message>
        <source>kept with the case and remembered here; never the patient&apos;s name</source>
        <translation>症例とともに記録し、この装置にも記憶します。患者の氏名は入力しないでください</translation>
    </message>
    <message>
        <source>kept with the sign-off; no patient&apos;s name</source>
        <translation>承認とともに記録します。患者の氏名は入力しないでください</translation>
    </message>
    <message>
        <source>Sign off</source>
        <translation>承認</translation>
    </message>
    <message>
        <source>the case may then be treated (Ctrl+Return)</source>
        <translation>承認すると、この症例を治療に使えます (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Reject: ask for a new scan</source>
        <translation>却下: 再撮像を依頼</translation>
    </message>
    <message>
        <source>needs your name and a reason; the worklist shows them, and the scan is not used</source>
        <translation>氏名と理由が必要です。ワークリストに表示され、このスキャンは使われません</translation>
    </message>
    <message>
        <source>✓  </source>
        <translation>✓  </translation>
    </message>
    <message>
        <source>!  </source>
        <translation>!  </translation>
    </message>
    <message>
        <source>○  </source>
        <translation>○  </translation>
    </message>
    <message>
        <source>no case open</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source>reason (the scan is not usable)</source>
        <translation>理由 (スキャンは使用できません)</translation>
    </message>
    <message>
        <source>note; the reason if you reject the scan</source>
        <translation>メモ。スキャンを却下する場合はその理由</translation>
    </message>
    <message>
        <source>ask for: %1</source>
        <translation>依頼内容: %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SignOffPresenter</name>
    <message>
        <source>The outlines follow skin and brain on every slice of the montage</source>
        <translation>一覧のすべての断面で、輪郭が皮膚と脳に沿っている</translation>
    </message>
    <message>
        <source>no brain model: the case holds the scalp alone</source>
        <translation>脳モデルなし: この症例には頭皮だけがあります</translation>
    </message>
    <message>
        <source>brain %1 ml%2, %3 the normal range of adults, %4 to %5 ml</source>
        <translation>脳 %1 ml%2、成人の正常範囲 %4〜%5 ml %3</translation>
    </message>
    <message>
        <source> (correction, not saved)</source>
        <translation> (修正中、未保存)</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>の範囲内</translation>
    </message>
    <message>
        <source>below</source>
        <translation>を下回ります</translation>
    </message>
    <message>
        <source>above</source>
        <translation>を上回ります</translation>
    </message>
    <message>
        <source>no case is open</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source>signed off already</source>
        <translation>承認済みです</translation>
    </message>
    <message>
        <source>a correction of the brain is not saved: save or discard it first (step 3)</source>
        <translation>脳の修正が保存されていません: 先に保存または破棄してください (手順 3)</translation>
    </message>
    <message>
        <source>%1 of %2 still to be ticked</source>
        <translation>%2 項目中 %1 項目が未確認です</translation>
    </message>
    <message>
        <source>your name or initials are missing</source>
        <translation>氏名またはイニシャルがありません</translation>
    </message>
    <message>
        <source>the scan is not usable: give the reason why it is signed off all the same, or reject it</source>
        <translation>スキャンは使用できません: それでも承認する理由を入力するか、却下してください</translation>
    </message>
    <message>
        <source>Signing off</source>
        <translation>承認しています</translation>
    </message>
    <message>
        <source>Rejecting the scan</source>
        <translation>スキャンを却下しています</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SliceView</name>
    <message>
        <source>axial</source>
        <translation>軸位断</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>冠状断</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>矢状断</translation>
    </message>
    <message>
        <source>left: crosshair   wheel: slice   right: zoom   middle: pan   Ctrl+left: window/level   double click: choose   R: zoom, pan and window as at first   right click: menu</source>
        <translation>左: 十字線   ホイール: 断面   右: 拡大縮小   中央: 移動   Ctrl+左: ウィンドウ/レベル   ダブルクリック: 選択   R: 倍率、位置、階調を最初の状態に   右クリック: メニュー</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>zoom, pan and window as at first, in all slices (R)</source>
        <translation>すべての断面の倍率、位置、階調を最初の状態に戻します (R)</translation>
    </message>
    <message>
        <source>%1  %2/%3</source>
        <translation>%1  %2/%3</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>value %1</source>
        <translation>値 %1</translation>
    </message>
    <message>
        <source>outside the scan</source>
        <translation>スキャンの外</translation>
    </message>
</context>
<context>
    <name>facenav::ui::T</name>
    <message>
        <source>%1 LOST</source>
        <translation>%1 追跡喪失</translation>
    </message>
    <message>
        <source>%1 weak</source>
        <translation>%1 追跡不安定</translation>
    </message>
    <message>
        <source>%1 tracked</source>
        <translation>%1 追跡中</translation>
    </message>
    <message>
        <source>quality %1</source>
        <translation>追跡品質 %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TargetList</name>
    <message>
        <source>double click or F2: rename   right click: more</source>
        <translation>ダブルクリックまたは F2: 名前の変更   右クリック: その他</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>Make active</source>
        <translation>選択中にする</translation>
    </message>
    <message>
        <source>Rename (F2)</source>
        <translation>名前の変更 (F2)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Mirror to the other side</source>
        <translation>反対側に鏡映</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Delete (Del)</source>
        <translation>削除 (Del)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TargetTools</name>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>a target at a known place of either side: M1, DLPFC, Beam F3 and F4, EEG sites</source>
        <translation>左右いずれかの既知の場所の標的: M1、DLPFC、Beam F3 と F4、脳波電極位置</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>targets in rows and columns round the active one</source>
        <translation>選択中の標的を囲む、行と列に並べた標的</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>copy, mirror, lock, order, compare</source>
        <translation>複製、鏡映、ロック、順序、比較</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>頭部</translation>
    </message>
    <message>
        <source>nasion, inion and tragi, which EEG sites are measured from</source>
        <translation>鼻根点、後頭結節、耳珠。脳波電極位置はここから測ります</translation>
    </message>
    <message>
        <source>EEG site</source>
        <translation>脳波電極位置</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Mirror to the other side</source>
        <translation>反対側に鏡映</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比較相手</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Set %1 at the crosshair</source>
        <translation>%1を十字線の位置に設定</translation>
    </message>
    <message>
        <source>Find again</source>
        <translation>再検出</translation>
    </message>
    <message>
        <source>Crosshair to</source>
        <translation>十字線の移動先</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TaskBar</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>stop this step; nothing half-done is kept (Esc)</source>
        <translation>この処理を中止します。途中のものは残りません (Esc)</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: 完了</translation>
    </message>
    <message>
        <source>%1: cancelled</source>
        <translation>%1: キャンセルしました</translation>
    </message>
    <message>
        <source>%1: %2  (%3 s)</source>
        <translation>%1: %2  (%3 s)</translation>
    </message>
    <message>
        <source>Could not be done: %1</source>
        <translation>実行できませんでした: %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TimeStrip</name>
    <message>
        <source>tall blue: on target; half as tall, orange: to be adjusted; thin grey: lost. Ticks below: pulses, thick where on target. Click or drag to go there</source>
        <translation>高い青: 標的上。半分の高さのオレンジ: 要調整。細い灰色: 追跡喪失。下の目盛り: パルス、太いものは標的上。クリックまたはドラッグで移動します</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TipPanel</name>
    <message>
        <source>MRI&apos;s skin over the pictures</source>
        <translation>画像に MRI の皮膚を重ねる</translation>
    </message>
    <message>
        <source>the MRI&apos;s skin where the head&apos;s pose puts it: its outline must lie on the face&apos;s, in both pictures (O)</source>
        <translation>頭の姿勢に基づいて描いた MRI の皮膚: 両方の画像で、その輪郭が顔の輪郭と一致していなければなりません (O)</translation>
    </message>
    <message>
        <source>distance of the coil&apos;s tip, or of the clicked spot, from the MRI&apos;s skin</source>
        <translation>コイルの先端、またはクリックした点から MRI の皮膚までの距離</translation>
    </message>
    <message>
        <source>distance of the coil&apos;s tip, or of the clicked spot, from the named place that is nearest</source>
        <translation>コイルの先端、またはクリックした点から、最も近い名前付きの場所までの距離</translation>
    </message>
    <message>
        <source>%1 Matches</source>
        <translation>%1 一致</translation>
    </message>
    <message>
        <source>tip or spot is where the figures say; kept in the session&apos;s log (R)</source>
        <translation>先端または点は数値の示す場所にあります。セッションの記録に残ります (R)</translation>
    </message>
    <message>
        <source>%1 Does not match</source>
        <translation>%1 不一致</translation>
    </message>
    <message>
        <source>tip or spot is elsewhere; kept in the session&apos;s log. Guidance is withheld until a measured check passes (W)</source>
        <translation>先端または点は別の場所にあります。セッションの記録に残ります。計測による確認に合格するまで誘導を行いません (W)</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TipPresenter</name>
    <message>
        <source>Not found in the other picture. Click a spot with detail that both cameras see.</source>
        <translation>もう一方の画像で見つかりません。両方のカメラから見える、特徴のある点をクリックしてください。</translation>
    </message>
    <message>
        <source>A camera moved, so that a clicked spot cannot be measured. Use the coil&apos;s tip.</source>
        <translation>カメラが動いたため、クリックした点を計測できません。コイルの先端を使ってください。</translation>
    </message>
    <message>
        <source>mm from the skin</source>
        <translation>mm 皮膚から</translation>
    </message>
    <message>
        <source>mm inside the skin</source>
        <translation>mm 皮膚の内側</translation>
    </message>
    <message>
        <source>mm outside the skin</source>
        <translation>mm 皮膚の外側</translation>
    </message>
    <message>
        <source>mm from nose or ear</source>
        <translation>mm 鼻または耳から</translation>
    </message>
    <message>
        <source>mm from %1</source>
        <translation>mm %1から</translation>
    </message>
    <message>
        <source>Align first (step 2); then the MRI&apos;s skin is drawn over both pictures.</source>
        <translation>先に位置合わせを行ってください (手順 2)。その後、両方の画像に MRI の皮膚を描きます。</translation>
    </message>
    <message>
        <source>Start guidance (step 3): the coil&apos;s tip is read while it is tracked.</source>
        <translation>誘導を開始してください (手順 3): コイルの追跡中に先端を読み取ります。</translation>
    </message>
    <message>
        <source>The clicked spot, white in both pictures (±%1 mm): is it where these figures say?</source>
        <translation>クリックした点 (両方の画像に白で表示、±%1 mm): 数値の示す場所にありますか?</translation>
    </message>
    <message>
        <source>Show face and coil to both cameras. Or hold a finger to nose or ear and click its tip in a picture.</source>
        <translation>顔とコイルを両方のカメラに見せてください。または、指を鼻か耳に当て、画像でその指先をクリックしてください。</translation>
    </message>
    <message>
        <source>Hold the coil&apos;s tip to nose or ear. Or hold a finger there and click its tip in a picture.</source>
        <translation>コイルの先端を鼻か耳に当ててください。または、指を当て、画像でその指先をクリックしてください。</translation>
    </message>
    <message>
        <source>Is the tip where these figures say?</source>
        <translation>先端は数値の示す場所にありますか?</translation>
    </message>
    <message>
        <source>matches: %1</source>
        <translation>一致: %1</translation>
    </message>
    <message>
        <source>DOES NOT MATCH, align again: %1</source>
        <translation>不一致、位置合わせをやり直してください: %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TreatPresenter</name>
    <message>
        <source>no pulses from outside: %1</source>
        <translation>外部からのパルスなし: %1</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>PAUSED: %1</source>
        <translation>一時停止中: %1</translation>
    </message>
    <message>
        <source>there is no session yet: start guidance first</source>
        <translation>セッションがまだありません: 先に誘導を開始してください</translation>
    </message>
    <message>
        <source>%1, %2 pulses</source>
        <translation>%1、パルス %2 回</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> / 計画 %1 回</translation>
    </message>
    <message>
        <source>: %1 on target, %2 outside, %3 with face or coil lost</source>
        <translation>: 標的上 %1、範囲外 %2、顔またはコイルの追跡喪失 %3</translation>
    </message>
    <message>
        <source>Opening the recording</source>
        <translation>記録を開いています</translation>
    </message>
    <message>
        <source>OPENING THE RECORDING</source>
        <translation>記録を開いています</translation>
    </message>
    <message>
        <source>take the picture first (step 1)</source>
        <translation>先に撮影してください (手順 1)</translation>
    </message>
    <message>
        <source>Aligning the head</source>
        <translation>頭の位置合わせをしています</translation>
    </message>
    <message>
        <source>ALIGNING: the face is measured and fitted to the scan</source>
        <translation>位置合わせ中: 顔を計測し、スキャンに合わせています</translation>
    </message>
    <message>
        <source>Going on with the session</source>
        <translation>セッションを続けます</translation>
    </message>
    <message>
        <source>ALIGNING: the face is fitted as in that session</source>
        <translation>位置合わせ中: そのセッションと同じように顔を合わせています</translation>
    </message>
    <message>
        <source>%1 is no longer in the plan: choose a target</source>
        <translation>%1 は計画にもうありません: 標的を選んでください</translation>
    </message>
    <message>
        <source>Starting the trackers</source>
        <translation>追跡を開始しています</translation>
    </message>
    <message>
        <source>STARTING: the trackers get ready</source>
        <translation>開始中: 追跡の準備をしています</translation>
    </message>
    <message>
        <source>no cameras</source>
        <translation>カメラなし</translation>
    </message>
    <message>
        <source>cameras %1 and %2, live</source>
        <translation>カメラ %1 と %2、ライブ</translation>
    </message>
    <message>
        <source>not aligned in this session</source>
        <translation>このセッションでは位置合わせ未実施</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TreatSide</name>
    <message>
        <source>a pulse was given now</source>
        <translation>今、照射しました</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>照準</translation>
    </message>
    <message>
        <source>where the coil is against the target</source>
        <translation>標的に対するコイルの位置</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>運動</translation>
    </message>
    <message>
        <source>motor hotspot and threshold: the muscle&apos;s answers</source>
        <translation>運動ホットスポットと運動閾値: 筋の反応</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>pause, pain, adverse events, source of the pulses, sound, second screen</source>
        <translation>一時停止、痛み、有害事象、パルスの入力元、音、第 2 画面</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>the alignment by eye: the MRI&apos;s skin over the pictures, and the coil&apos;s tip or a clicked spot on the face</source>
        <translation>目視による位置合わせの確認: 画像に重ねた MRI の皮膚と、コイルの先端または顔の上でクリックした点</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TreatWorkspace</name>
    <message>
        <source>RECORDING ENDED: end the session, or start again</source>
        <translation>記録の終わり: セッションを終了するか、もう一度開始してください</translation>
    </message>
    <message>
        <source>CAMERAS MOVED: repair them (step 1)</source>
        <translation>カメラが動きました: 修復してください (手順 1)</translation>
    </message>
    <message>
        <source>NO CASE OPEN</source>
        <translation>症例が開かれていません</translation>
    </message>
    <message>
        <source>NOT SIGNED OFF</source>
        <translation>未承認</translation>
    </message>
    <message>
        <source>CAMERAS CHANGED: open them (step 1)</source>
        <translation>カメラが変わりました: 開いてください (手順 1)</translation>
    </message>
    <message>
        <source>READY: start guidance</source>
        <translation>準備完了: 誘導を開始してください</translation>
    </message>
    <message>
        <source>NOT ALIGNED</source>
        <translation>位置合わせ未実施</translation>
    </message>
    <message>
        <source>CAMERAS moved</source>
        <translation>カメラ ずれあり</translation>
    </message>
    <message>
        <source>CAMERAS ready</source>
        <translation>カメラ 準備完了</translation>
    </message>
    <message>
        <source>CAMERAS none</source>
        <translation>カメラ なし</translation>
    </message>
    <message>
        <source>FACE idle</source>
        <translation>顔 待機</translation>
    </message>
    <message>
        <source>COIL idle</source>
        <translation>コイル 待機</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>the MRI along the coil&apos;s axis, along and across its handle (M)</source>
        <translation>コイルの軸に沿った MRI (ハンドル方向と横断方向) (M)</translation>
    </message>
    <message>
        <source>in 3-D</source>
        <translation>3-D に表示</translation>
    </message>
    <message>
        <source>the same two slices in the 3-D scene, under the coil (Shift+M)</source>
        <translation>同じ 2 つの断面を 3-D シーンのコイルの下に表示します (Shift+M)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>the electric field of the coil as it is held now, in colours on the brain, in V/m (E)</source>
        <translation>今のコイルの持ち方での電場を脳の上に色で示します (V/m) (E)</translation>
    </message>
    <message>
        <source>cameras or a recording, their calibration and pictures (Ctrl+R)</source>
        <translation>カメラまたは記録、その較正と画像 (Ctrl+R)</translation>
    </message>
    <message>
        <source>measure the face and fit it to the scan; no click is needed (Ctrl+L)</source>
        <translation>顔を計測してスキャンに合わせます。クリックは不要です (Ctrl+L)</translation>
    </message>
    <message>
        <source>start, stop or go on with guidance; the session stays open (Space)</source>
        <translation>誘導を開始、停止、再開します。セッションは開いたままです (Space)</translation>
    </message>
    <message>
        <source>4 End…</source>
        <translation>4 終了…</translation>
    </message>
    <message>
        <source>end the session: asks for pain and adverse events, then shows the report (Ctrl+E)</source>
        <translation>セッションを終了します: 痛みと有害事象を尋ねてから、レポートを表示します (Ctrl+E)</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>1 Cameras %1</source>
        <translation>1 カメラ %1</translation>
    </message>
    <message>
        <source>2 Align %1</source>
        <translation>2 位置合わせ %1</translation>
    </message>
    <message>
        <source>3 Guide %1  stop</source>
        <translation>3 誘導 %1  停止</translation>
    </message>
    <message>
        <source>3 Guide %1  go on</source>
        <translation>3 誘導 %1  再開</translation>
    </message>
    <message>
        <source>3 Guide %1  start</source>
        <translation>3 誘導 %1  開始</translation>
    </message>
    <message>
        <source>open a case first (Ctrl+O)</source>
        <translation>先に症例を開いてください (Ctrl+O)</translation>
    </message>
    <message>
        <source>the target to guide to: %1</source>
        <translation>誘導先の標的: %1</translation>
    </message>
    <message>
        <source>the coil that is held: %1</source>
        <translation>手に持つコイル: %1</translation>
    </message>
</context>
<context>
    <name>facenav::ui::WindowHeader</name>
    <message>
        <source>CAMERAS no images</source>
        <translation>カメラ 画像なし</translation>
    </message>
    <message>
        <source>FACE tracked</source>
        <translation>顔 追跡中</translation>
    </message>
    <message>
        <source>COIL tracked</source>
        <translation>コイル 追跡中</translation>
    </message>
    <message>
        <source>FaceNav</source>
        <translation>FaceNav</translation>
    </message>
    <message>
        <source>from a frame&apos;s arrival to its figures; frames left out because a newer one was there</source>
        <translation>フレームの到着からその数値が出るまでの時間; より新しいフレームがあったため飛ばしたフレーム</translation>
    </message>
</context>
<context>
    <name>facenav::ui::WorklistPage</name>
    <message>
        <source>Type to filter: state, case, name, finding</source>
        <translation>入力して絞り込み: 状態、症例、名前、所見</translation>
    </message>
    <message>
        <source>every word must occur somewhere in the line (just type; Esc clears)</source>
        <translation>すべての語が行のどこかに含まれるものを表示します (そのまま入力。Esc で解除)</translation>
    </message>
    <message>
        <source>Cases folder…</source>
        <translation>症例フォルダー…</translation>
    </message>
    <message>
        <source>where cases are kept and made (remembered)</source>
        <translation>症例を保存し、作成する場所 (記憶します)</translation>
    </message>
    <message>
        <source>worklist</source>
        <translation>ワークリスト</translation>
    </message>
    <message>
        <source>open the chosen line of the worklist</source>
        <translation>選んだワークリストの行を開きます</translation>
    </message>
    <message>
        <source>label the chosen case</source>
        <translation>選んだ症例にラベルを付けます</translation>
    </message>
    <message>
        <source>put the chosen line back into the queue</source>
        <translation>選んだ行を待ち行列に戻します</translation>
    </message>
    <message>
        <source>delete the chosen case, after a question; take a line off the list</source>
        <translation>選んだ症例を確認のうえ削除します。行を一覧から外します</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>open the case to check it (Return, double click)</source>
        <translation>症例を開いて確認します (Return、ダブルクリック)</translation>
    </message>
    <message>
        <source>Show series</source>
        <translation>シリーズを表示</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>ラベル…</translation>
    </message>
    <message>
        <source>what you call the case here; kept with it, private to you (F2)</source>
        <translation>この装置での症例の呼び名。症例とともに保存され、あなただけのものです (F2)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>stop preparing; nothing half-done is kept (Del)</source>
        <translation>準備を中止します。途中のものは残りません (Del)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>put the line back into the queue (F5)</source>
        <translation>行を待ち行列に戻します (F5)</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>一覧から外す</translation>
    </message>
    <message>
        <source>forget this input; no file is touched (Del)</source>
        <translation>この入力を一覧から消します。ファイルには触れません (Del)</translation>
    </message>
    <message>
        <source>label new cases with the patient&apos;s name</source>
        <translation>新しい症例に患者名のラベルを付ける</translation>
    </message>
    <message>
        <source>from the DICOM files; a case holds no name unless this is on (remembered)</source>
        <translation>DICOM ファイルの氏名を使います。オフの場合、症例に氏名は残りません (記憶します)</translation>
    </message>
    <message>
        <source>FaceNav</source>
        <translation>FaceNav</translation>
    </message>
    <message>
        <source>Delete case %1?</source>
        <translation>症例 %1 を削除しますか?</translation>
    </message>
    <message>
        <source>Its model, targets and sessions go to the trash of this computer and can be restored from there.
%1</source>
        <translation>モデル、標的、セッションはこのコンピューターのゴミ箱に移り、そこから復元できます。
%1</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>Move to the trash</source>
        <translation>ゴミ箱に移す</translation>
    </message>
    <message>
        <source>Sign off, or reject the scan…</source>
        <translation>承認、またはスキャンを却下…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>削除…</translation>
    </message>
    <message>
        <source>cases: %1</source>
        <translation>症例: %1</translation>
    </message>
    <message>
        <source>Drop a DICOM folder or a NIfTI file anywhere in the window: it is queued and prepared here.</source>
        <translation>DICOM フォルダーまたは NIfTI ファイルをウィンドウのどこにでもドロップしてください: 待ち行列に入り、ここで準備されます。</translation>
    </message>
    <message>
        <source>Cases folder</source>
        <translation>症例フォルダー</translation>
    </message>
</context>
<context>
    <name>facenav::ui::WorklistPresenter</name>
    <message>
        <source>unreadable</source>
        <translation>読み込み不可</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>準備済み</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>確認済み</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>計画済み</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>却下</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>queued</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>準備中</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>%1: choose one (double click)</source>
        <translation>%1: 1 つ選んでください (ダブルクリック)</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>キャンセル済み</translation>
    </message>
    <message>
        <source>now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 時間</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 日</translation>
    </message>
    <message>
        <source>%1 weeks</source>
        <translation>%1 週</translation>
    </message>
    <message>
        <source>Reading the worklist</source>
        <translation>ワークリストを読み込んでいます</translation>
    </message>
    <message>
        <source>%1 is no case of this list</source>
        <translation>%1 はこの一覧の症例ではありません</translation>
    </message>
    <message>
        <source>case %1 is open. Open another case first, then delete this one.</source>
        <translation>症例 %1 は開かれています。先に別の症例を開いてから、この症例を削除してください。</translation>
    </message>
    <message>
        <source>case %1 could not be moved to the trash. Delete its folder by hand: %2</source>
        <translation>症例 %1 をゴミ箱に移せませんでした。フォルダーを手動で削除してください: %2</translation>
    </message>
    <message>
        <source>case %1 is in the trash: %2</source>
        <translation>症例 %1 はゴミ箱にあります: %2</translation>
    </message>
</context>
<context>
    <name>facenav::ui::WorklistTable</name>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>症例</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>所見</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>確認者</translation>
    </message>
    <message>
        <source>What to look at</source>
        <translation>確認する点</translation>
    </message>
</context>
</TS>
