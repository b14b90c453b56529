<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja">
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
        <translation>MEP マップ (σ %1 mm): 最大 %2 uV、位置 %3、重心 %4 (RAS mm)、%5 uV 以上の面積 %6 mm²、%8 パルス中 %7 で反応あり</translation>
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
    <message>
        <source>tick those to draw</source>
        <translation>描くものにチェックを入れてください</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>compiled in</source>
        <translation>組み込み</translation>
    </message>
    <message>
        <source>data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>FaceNav</source>
        <translation>FaceNav</translation>
    </message>
    <message>
        <source>Is this the patient of case %1?</source>
        <translation>この方は症例 %1 の患者ですか?</translation>
    </message>
    <message>
        <source>%1

Ask for name and date of birth. Say yes only if they are those of this case: with another person&apos;s MRI the target would be wrong.</source>
        <translation>%1

氏名と生年月日を尋ねてください。この症例のものと一致するときだけ「はい」を選んでください。別の人の MRI では標的が誤った場所になります。</translation>
    </message>
    <message>
        <source>No, do not align</source>
        <translation>いいえ、位置合わせしない</translation>
    </message>
    <message>
        <source>Yes, checked: align</source>
        <translation>はい、確認済み: 位置合わせする</translation>
    </message>
    <message>
        <source>linked in facenav-lab</source>
        <translation>facenav-lab でリンク</translation>
    </message>
</context>
<context>
    <name>SecondCoilChoice</name>
    <message>
        <source>two coils are followed: say which one gives the pulses (tool Session)</source>
        <translation>2 つのコイルを追跡します: どちらで刺激するかを指定してください (「セッション」ツール)</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>the brain measures %1 ml, adults have %2 to %3 ml: check its outline</source>
        <translation>脳の体積は %1 ml、成人は %2〜%3 ml です: 輪郭を確認してください</translation>
    </message>
    <message>
        <source>Farkas 1994, North American whites, without a second population</source>
        <translation>Farkas 1994, North American whites, without a second population</translation>
    </message>
    <message>
        <source>67 studies pooled, 22 638 people (PMC9029890): 31.2 (1.5) Middle Eastern, 31.4 (2.5) White, 36.4 (1.6) Asian, 38.5 (3.2) African</source>
        <translation>67 studies pooled, 22 638 people (PMC9029890): 31.2 (1.5) Middle Eastern, 31.4 (2.5) White, 36.4 (1.6) Asian, 38.5 (3.2) African</translation>
    </message>
    <message>
        <source>Farkas 1994; Kenyan men 51.0 (1.9), women 47.6 (3.1) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</source>
        <translation>Farkas 1994; Kenyan men 51.0 (1.9), women 47.6 (3.1) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</translation>
    </message>
    <message>
        <source>Farkas 1994; Kenyan men 43.2 (3.8), women 40.7 (3.7) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</source>
        <translation>Farkas 1994; Kenyan men 43.2 (3.8), women 40.7 (3.7) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</translation>
    </message>
    <message>
        <source>Farkas 1994; Kenyan men 134 (5), women 130 (4) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</source>
        <translation>Farkas 1994; Kenyan men 134 (5), women 130 (4) (Virdi 2019, doi 10.1186/s40902-019-0191-7)</translation>
    </message>
    <message>
        <source>ANSUR II 2012, men 154 (6), women 148 (5)</source>
        <translation>ANSUR II 2012, men 154 (6), women 148 (5)</translation>
    </message>
    <message>
        <source>ANSUR II 2012, men 200 (7), women 190 (7); British women 180 (7) (anthropometry tables of the City University of Hong Kong)</source>
        <translation>ANSUR II 2012, men 200 (7), women 190 (7); British women 180 (7) (anthropometry tables of the City University of Hong Kong)</translation>
    </message>
    <message>
        <source>adults, both sexes</source>
        <translation>成人、男女</translation>
    </message>
    <message>
        <source>inner corners of the eyes</source>
        <translation>両目の内眼角</translation>
    </message>
    <message>
        <source>centres of the closed lids</source>
        <translation>閉じたまぶたの中心</translation>
    </message>
    <message>
        <source>lid centre R</source>
        <translation>まぶたの中心 R</translation>
    </message>
    <message>
        <source>lid centre L</source>
        <translation>まぶたの中心 L</translation>
    </message>
    <message>
        <source>nose length, root to tip</source>
        <translation>鼻の長さ (鼻根から鼻尖)</translation>
    </message>
    <message>
        <source>nose height, root to base</source>
        <translation>鼻の高さ (鼻根から鼻下点)</translation>
    </message>
    <message>
        <source>nose depth, base to tip</source>
        <translation>鼻の奥行き (鼻下点から鼻尖)</translation>
    </message>
    <message>
        <source>nose width over the wings</source>
        <translation>鼻翼間の幅</translation>
    </message>
    <message>
        <source>nose tip to inner corner of the right eye</source>
        <translation>鼻尖から右の内眼角まで</translation>
    </message>
    <message>
        <source>nose tip to inner corner of the left eye</source>
        <translation>鼻尖から左の内眼角まで</translation>
    </message>
    <message>
        <source>nose root to chin</source>
        <translation>鼻根からオトガイまで</translation>
    </message>
    <message>
        <source>width of the face</source>
        <translation>顔の幅</translation>
    </message>
    <message>
        <source>ear to ear (tragus)</source>
        <translation>耳から耳まで (耳珠)</translation>
    </message>
    <message>
        <source>right tragus to nose root</source>
        <translation>右耳珠から鼻根まで</translation>
    </message>
    <message>
        <source>left tragus to nose root</source>
        <translation>左耳珠から鼻根まで</translation>
    </message>
    <message>
        <source>right tragus to nose tip</source>
        <translation>右耳珠から鼻尖まで</translation>
    </message>
    <message>
        <source>left tragus to nose tip</source>
        <translation>左耳珠から鼻尖まで</translation>
    </message>
    <message>
        <source>width of the head</source>
        <translation>頭の幅</translation>
    </message>
    <message>
        <source>length of the head</source>
        <translation>頭の長さ</translation>
    </message>
    <message>
        <source>no pipe can be made</source>
        <translation>パイプを作成できません</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>ほかのプログラムを閉じてください</translation>
    </message>
    <message>
        <source>no process can be started</source>
        <translation>プロセスを起動できません</translation>
    </message>
    <message>
        <source>cannot be started (%1)</source>
        <translation>起動できません (%1)</translation>
    </message>
    <message>
        <source>is it installed?</source>
        <translation>インストールされていますか?</translation>
    </message>
    <message>
        <source>%1 fields were expected, %2 found</source>
        <translation>%1 個の欄が必要ですが、%2 個でした</translation>
    </message>
    <message>
        <source>is empty, a CSV file with a header line was expected</source>
        <translation>空です。見出し行のある CSV ファイルが必要です</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; is missing in the header line</source>
        <translation>見出し行に列 &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>the value of column &apos;%1&apos; is missing</source>
        <translation>列 &apos;%1&apos; の値がありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in column &apos;%2&apos; is no number</source>
        <translation>列 &apos;%2&apos; の &apos;%1&apos; は数値ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in column &apos;%2&apos; is no whole number</source>
        <translation>列 &apos;%2&apos; の &apos;%1&apos; は整数ではありません</translation>
    </message>
    <message>
        <source>folder does not exist</source>
        <translation>フォルダーがありません</translation>
    </message>
    <message>
        <source>create it first</source>
        <translation>先に作成してください</translation>
    </message>
    <message>
        <source>folder is not writable</source>
        <translation>フォルダーに書き込めません</translation>
    </message>
    <message>
        <source>choose another</source>
        <translation>別のものを選んでください</translation>
    </message>
    <message>
        <source>choose another place (&apos;-o -&apos; writes a file to standard output)</source>
        <translation>別の場所を選んでください (&apos;-o -&apos; は標準出力に書き出します)</translation>
    </message>
    <message>
        <source>is a link that leads nowhere</source>
        <translation>行き先のないリンクです</translation>
    </message>
    <message>
        <source>is neither a file nor a folder, and is not replaced</source>
        <translation>ファイルでもフォルダーでもないため、置き換えません</translation>
    </message>
    <message>
        <source>belongs to the system, and is not replaced</source>
        <translation>システムのものなので、置き換えません</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>書き込めません (%1)</translation>
    </message>
    <message>
        <source>check free disk space and permissions</source>
        <translation>ディスクの空き容量とアクセス権を確認してください</translation>
    </message>
    <message>
        <source>is not valid JSON (at byte %1)</source>
        <translation>正しい JSON ではありません (%1 バイト目)</translation>
    </message>
    <message>
        <source>restore the file or write it again</source>
        <translation>ファイルを復元するか、書き直してください</translation>
    </message>
    <message>
        <source>is not valid JSON (a number out of range)</source>
        <translation>正しい JSON ではありません (範囲外の数値)</translation>
    </message>
    <message>
        <source>a JSON object was expected</source>
        <translation>JSON オブジェクトが必要です</translation>
    </message>
    <message>
        <source>an object was expected</source>
        <translation>オブジェクトが必要です</translation>
    </message>
    <message>
        <source>required key is missing; see resources/doc/formats.md</source>
        <translation>必須のキーがありません。resources/doc/formats.md を参照してください</translation>
    </message>
    <message>
        <source>required key is missing</source>
        <translation>必須のキーがありません</translation>
    </message>
    <message>
        <source>a list was expected</source>
        <translation>リストが必要です</translation>
    </message>
    <message>
        <source>a number was expected</source>
        <translation>数値が必要です</translation>
    </message>
    <message>
        <source>a finite number was expected</source>
        <translation>有限の数値が必要です</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>数値が大きすぎます</translation>
    </message>
    <message>
        <source>a whole number was expected</source>
        <translation>整数が必要です</translation>
    </message>
    <message>
        <source>a text was expected</source>
        <translation>文字列が必要です</translation>
    </message>
    <message>
        <source>a list of %1 numbers was expected</source>
        <translation>%1 個の数値のリストが必要です</translation>
    </message>
    <message>
        <source>compiled in</source>
        <translation>組み込み</translation>
    </message>
    <message>
        <source>unknown reason of loss &apos;%1&apos;</source>
        <translation>追跡喪失の理由 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>use no_face, few_features, no_marker, high_residual, camera or stale</source>
        <translation>no_face、few_features、no_marker、high_residual、camera、stale のいずれかを使ってください</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>%1 バイトより長くなっています</translation>
    </message>
    <message>
        <source>is not valid UTF-8</source>
        <translation>正しい UTF-8 ではありません</translation>
    </message>
    <message>
        <source>contains a control character</source>
        <translation>制御文字を含んでいます</translation>
    </message>
    <message>
        <source>contains a mark that turns the reading direction</source>
        <translation>文字の向きを変える記号を含んでいます</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 が空です</translation>
    </message>
    <message>
        <source>give one</source>
        <translation>入力してください</translation>
    </message>
    <message>
        <source>type it again</source>
        <translation>入力し直してください</translation>
    </message>
    <message>
        <source>unknown instruction set &apos;%1&apos; in FACENAV_SIMD</source>
        <translation>FACENAV_SIMD の命令セット &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>set it to base, or unset it</source>
        <translation>base に設定するか、設定を外してください</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>標準出力</translation>
    </message>
    <message>
        <source>cannot be read back</source>
        <translation>読み戻せません</translation>
    </message>
    <message>
        <source>check free disk space</source>
        <translation>ディスクの空き容量を確認してください</translation>
    </message>
    <message>
        <source>is a folder, a file is written here</source>
        <translation>フォルダーです。ここにはファイルを書き出します</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>別の場所を選んでください</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>書き込めませんでした</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>書き込めません</translation>
    </message>
    <message>
        <source>file does not exist</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>パスを確認してください</translation>
    </message>
    <message>
        <source>is a folder, a file was expected</source>
        <translation>フォルダーです。ファイルが必要です</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>読み込めません</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>アクセス権を確認してください</translation>
    </message>
    <message>
        <source>a folder cannot be written to standard output</source>
        <translation>フォルダーは標準出力に書き出せません</translation>
    </message>
    <message>
        <source>give the folder a name</source>
        <translation>フォルダーの名前を指定してください</translation>
    </message>
    <message>
        <source>is a file, a folder is written here</source>
        <translation>ファイルです。ここにはフォルダーを書き出します</translation>
    </message>
    <message>
        <source>exists already and is not empty</source>
        <translation>既にあり、空ではありません</translation>
    </message>
    <message>
        <source>choose another folder or remove it</source>
        <translation>別のフォルダーを選ぶか、削除してください</translation>
    </message>
    <message>
        <source>was filled by someone else meanwhile</source>
        <translation>その間に別の書き込みがありました</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>the archive cannot be read: %1</source>
        <translation>アーカイブファイルを読み込めません: %1</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>ファイルをもう一度コピーするか、書き出してください</translation>
    </message>
    <message>
        <source>it holds a name that leads elsewhere</source>
        <translation>別の場所を指す名前を含んでいます</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large</source>
        <translation>&apos;%1&apos; が大きすぎます</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged</source>
        <translation>&apos;%1&apos; が壊れています</translation>
    </message>
    <message>
        <source>cannot be packed: %1</source>
        <translation>まとめられません: %1</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>空です</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not in it</source>
        <translation>&apos;%1&apos; が含まれていません</translation>
    </message>
    <message>
        <source>rigid fit: all weights are zero</source>
        <translation>剛体の当てはめ: 重みがすべて 0 です</translation>
    </message>
    <message>
        <source>rigid fit: fewer than 3 point pairs</source>
        <translation>剛体の当てはめ: 点の組が 3 組未満です</translation>
    </message>
    <message>
        <source>rigid fit: the points lie on one line, the rotation is not determined</source>
        <translation>剛体の当てはめ: 点が一直線上にあり、回転が定まりません</translation>
    </message>
    <message>
        <source>transform holds a number that is not finite</source>
        <translation>変換に有限でない数値があります</translation>
    </message>
    <message>
        <source>transform is not rigid (its axes are not orthonormal)</source>
        <translation>変換が剛体変換ではありません (軸が直交していません)</translation>
    </message>
    <message>
        <source>transform is mirrored (determinant -1), a left-right flip</source>
        <translation>変換が鏡映です (行列式 -1)。左右が反転します</translation>
    </message>
    <message>
        <source>transform&apos;s last row is not 0 0 0 1</source>
        <translation>変換の最終行が 0 0 0 1 ではありません</translation>
    </message>
    <message>
        <source>a number &gt;= 0 was expected</source>
        <translation>0 以上の数値が必要です</translation>
    </message>
    <message>
        <source>a symmetric matrix was expected</source>
        <translation>対称行列が必要です</translation>
    </message>
    <message>
        <source>a covariance has no negative eigenvalue</source>
        <translation>共分散に負の固有値はありません</translation>
    </message>
    <message>
        <source>a number in 0..1 was expected</source>
        <translation>0..1 の数値が必要です</translation>
    </message>
    <message>
        <source>cannot be set aside (%1)</source>
        <translation>退避できません (%1)</translation>
    </message>
    <message>
        <source>align again before the next session</source>
        <translation>次のセッションの前に位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>schema version %1: this case was written by a newer FaceNav and was not changed</source>
        <translation>スキーマ版 %1: この症例はより新しい FaceNav で書かれたもので、変更していません</translation>
    </message>
    <message>
        <source>update FaceNav</source>
        <translation>FaceNav を更新してください</translation>
    </message>
    <message>
        <source>schema version %1 is not known, this FaceNav reads %2; prepare the case again</source>
        <translation>スキーマ版 %1 は不明です。この FaceNav が読めるのは %2 です。症例を準備し直してください</translation>
    </message>
    <message>
        <source>a file name inside the case was expected</source>
        <translation>症例内のファイル名が必要です</translation>
    </message>
    <message>
        <source>exists and is no case</source>
        <translation>既にありますが、症例ではありません</translation>
    </message>
    <message>
        <source>a case exists there already</source>
        <translation>そこには既に症例があります</translation>
    </message>
    <message>
        <source>choose another folder, or replace it</source>
        <translation>別のフォルダーを選ぶか、置き換えてください</translation>
    </message>
    <message>
        <source>the disk has %1 MB left, a case of this scan needs about %2 MB</source>
        <translation>ディスクの残りは %1 MB です。このスキャンの症例には約 %2 MB 必要です</translation>
    </message>
    <message>
        <source>free some space or choose another disk</source>
        <translation>空き容量を増やすか、別のディスクを選んでください</translation>
    </message>
    <message>
        <source>this case holds no MRI, only the face as cameras measured it</source>
        <translation>この症例には MRI がなく、カメラで計測した顔だけがあります</translation>
    </message>
    <message>
        <source>use it with &apos;facenav-gui --home&apos; or &apos;facenav track&apos;</source>
        <translation>&apos;facenav-gui --home&apos; または &apos;facenav track&apos; で使ってください</translation>
    </message>
    <message>
        <source>the label is longer than %1 bytes</source>
        <translation>ラベルが %1 バイトより長くなっています</translation>
    </message>
    <message>
        <source>choose a shorter one</source>
        <translation>短いものにしてください</translation>
    </message>
    <message>
        <source>this scan does not lie where the case&apos;s scan lies: its targets would point elsewhere</source>
        <translation>このスキャンは症例のスキャンと位置が異なります: 標的が別の場所を指すことになります</translation>
    </message>
    <message>
        <source>this scan does not lie where the case&apos;s scan lies: the poses of its sessions would point elsewhere</source>
        <translation>このスキャンは症例のスキャンと位置が異なります: セッションの姿勢が別の場所を指すことになります</translation>
    </message>
    <message>
        <source>the case has no MRI that this scan could be compared with: its targets would point elsewhere</source>
        <translation>症例にこのスキャンと比べられる MRI がありません: 標的が別の場所を指すことになります</translation>
    </message>
    <message>
        <source>the case has no MRI that this scan could be compared with: the poses of its sessions would point elsewhere</source>
        <translation>症例にこのスキャンと比べられる MRI がありません: セッションの姿勢が別の場所を指すことになります</translation>
    </message>
    <message>
        <source>make a new case</source>
        <translation>新しい症例を作ってください</translation>
    </message>
    <message>
        <source>make a new case, or remove the targets first</source>
        <translation>新しい症例を作るか、先に標的を削除してください</translation>
    </message>
    <message>
        <source>no such case folder</source>
        <translation>その症例フォルダーはありません</translation>
    </message>
    <message>
        <source>prepare the case first</source>
        <translation>先に症例を準備してください</translation>
    </message>
    <message>
        <source>is no case (no case.json in it)</source>
        <translation>症例ではありません (case.json がありません)</translation>
    </message>
    <message>
        <source>the case is incomplete, a file is missing</source>
        <translation>症例が不完全です。ファイルが足りません</translation>
    </message>
    <message>
        <source>prepare the case again</source>
        <translation>症例を準備し直してください</translation>
    </message>
    <message>
        <source>check disk space and permissions</source>
        <translation>ディスクの空き容量とアクセス権を確認してください</translation>
    </message>
    <message>
        <source>this case has an MRI: a face does not replace it</source>
        <translation>この症例には MRI があります: 顔で置き換えることはできません</translation>
    </message>
    <message>
        <source>the case holds a brain mask corrected by hand, which would be lost</source>
        <translation>症例に手で修正した脳マスクがあり、失われることになります</translation>
    </message>
    <message>
        <source>the case holds an unfinished correction of the brain mask, which would be lost</source>
        <translation>症例に途中の脳マスク修正があり、失われることになります</translation>
    </message>
    <message>
        <source>choose another folder, or --discard-edits</source>
        <translation>別のフォルダーを選ぶか、--discard-edits を指定してください</translation>
    </message>
    <message>
        <source>the case has no brain mask to correct</source>
        <translation>症例に修正できる脳マスクがありません</translation>
    </message>
    <message>
        <source>the corrected mask lies on another grid than the scan</source>
        <translation>修正したマスクとスキャンの格子が異なります</translation>
    </message>
    <message>
        <source>correct this case&apos;s own mask</source>
        <translation>この症例自身のマスクを修正してください</translation>
    </message>
    <message>
        <source>is not a folder</source>
        <translation>フォルダーではありません</translation>
    </message>
    <message>
        <source>choose another place to export to</source>
        <translation>別の書き出し先を選んでください</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>既にあります</translation>
    </message>
    <message>
        <source>choose another folder, or --replace</source>
        <translation>別のフォルダーを選ぶか、--replace を指定してください</translation>
    </message>
    <message>
        <source>a picture could not be written</source>
        <translation>画像を書き込めませんでした</translation>
    </message>
    <message>
        <source>this picture of the face is missing, or not of its rig&apos;s size</source>
        <translation>この顔の画像がないか、大きさがカメラ構成と合いません</translation>
    </message>
    <message>
        <source>delete the folder face_looks; the next session makes new key frames</source>
        <translation>フォルダー face_looks を削除してください。次のセッションで新しいキーフレームを作ります</translation>
    </message>
    <message>
        <source>version 1 was expected</source>
        <translation>バージョン 1 が必要です</translation>
    </message>
    <message>
        <source>is a file, a folder was expected</source>
        <translation>ファイルです。フォルダーが必要です</translation>
    </message>
    <message>
        <source>move it elsewhere</source>
        <translation>ほかの場所に移してください</translation>
    </message>
    <message>
        <source>a standard error is not negative</source>
        <translation>標準誤差は負になりません</translation>
    </message>
    <message>
        <source>a topic of the import check was expected</source>
        <translation>取り込み確認の項目が必要です</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>使用不可</translation>
    </message>
    <message>
        <source>fine, caution or not usable was expected</source>
        <translation>fine、caution、not usable のいずれかが必要です</translation>
    </message>
    <message>
        <source>a file under overlays/ was expected</source>
        <translation>overlays/ 内のファイルが必要です</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no kind of overlay</source>
        <translation>&apos;%1&apos; というオーバーレイの種類はありません</translation>
    </message>
    <message>
        <source>map, mask, tracts or mesh</source>
        <translation>map、mask、tracts、mesh のいずれかです</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no space</source>
        <translation>&apos;%1&apos; という空間はありません</translation>
    </message>
    <message>
        <source>mni or native</source>
        <translation>mni または native です</translation>
    </message>
    <message>
        <source>an overlay&apos;s opacity lies between 0 and 1</source>
        <translation>オーバーレイの不透明度は 0〜1 です</translation>
    </message>
    <message>
        <source>give another</source>
        <translation>別の値を入力してください</translation>
    </message>
    <message>
        <source>a map&apos;s threshold is 0 or more, for both signs</source>
        <translation>マップの閾値は 0 以上です (正負とも)</translation>
    </message>
    <message>
        <source>a map&apos;s colours end above its threshold</source>
        <translation>マップの色の上限は閾値より大きくなければなりません</translation>
    </message>
    <message>
        <source>give a lower threshold or a higher end</source>
        <translation>閾値を下げるか、上限を上げてください</translation>
    </message>
    <message>
        <source>the overlay&apos;s name</source>
        <translation>オーバーレイの名前</translation>
    </message>
    <message>
        <source>there is an overlay &apos;%1&apos; already</source>
        <translation>オーバーレイ &apos;%1&apos; は既にあります</translation>
    </message>
    <message>
        <source>give another name</source>
        <translation>別の名前を付けてください</translation>
    </message>
    <message>
        <source>object must be head or coil, not &apos;%1&apos;</source>
        <translation>対象は head か coil でなければなりません。&apos;%1&apos; は使えません</translation>
    </message>
    <message>
        <source>the quaternion is not of unit length</source>
        <translation>四元数の長さが 1 ではありません</translation>
    </message>
    <message>
        <source>quality must lie in 0..1</source>
        <translation>品質は 0..1 でなければなりません</translation>
    </message>
    <message>
        <source>status must be tracked or lost, not &apos;%1&apos;</source>
        <translation>状態は tracked か lost でなければなりません。&apos;%1&apos; は使えません</translation>
    </message>
    <message>
        <source>example: change every number</source>
        <translation>例: すべての数値を変更してください</translation>
    </message>
    <message>
        <source>the protocol&apos;s name</source>
        <translation>プロトコルの名前</translation>
    </message>
    <message>
        <source>the protocol&apos;s note</source>
        <translation>プロトコルのメモ</translation>
    </message>
    <message>
        <source>a protocol&apos;s version starts at 1</source>
        <translation>プロトコルのバージョンは 1 から始まります</translation>
    </message>
    <message>
        <source>a whole number from 1 was expected</source>
        <translation>1 以上の整数が必要です</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>別の名前を選んでください</translation>
    </message>
    <message>
        <source>pulses: in one session, over all trains. frequency_hz: within a train; 0: no fixed rate. pause_s: between trains. threshold_pct or output_pct: the strength; delete the other. A changed protocol needs a new version</source>
        <translation>pulses: in one session, over all trains. frequency_hz: within a train; 0: no fixed rate. pause_s: between trains. threshold_pct or output_pct: the strength; delete the other. A changed protocol needs a new version</translation>
    </message>
    <message>
        <source>this is the example, no protocol</source>
        <translation>これは例で、プロトコルではありません</translation>
    </message>
    <message>
        <source>give it your own name and numbers</source>
        <translation>自分の名前と数値を入力してください</translation>
    </message>
    <message>
        <source>the case has version %1 of &apos;%2&apos; with other numbers</source>
        <translation>症例には &apos;%2&apos; のバージョン %1 が別の数値で入っています</translation>
    </message>
    <message>
        <source>give the changed protocol a new version</source>
        <translation>変更したプロトコルに新しいバージョンを付けてください</translation>
    </message>
    <message>
        <source>the protocol cannot be removed (%1)</source>
        <translation>プロトコルを削除できません (%1)</translation>
    </message>
    <message>
        <source>check the folder&apos;s permissions</source>
        <translation>フォルダーのアクセス権を確認してください</translation>
    </message>
    <message>
        <source>it was removed</source>
        <translation>削除されています</translation>
    </message>
    <message>
        <source>another program writes this session</source>
        <translation>別のプログラムがこのセッションに書き込んでいます</translation>
    </message>
    <message>
        <source>end it there first</source>
        <translation>先にそちらを終了してください</translation>
    </message>
    <message>
        <source>the picture cannot be encoded</source>
        <translation>画像を符号化できません</translation>
    </message>
    <message>
        <source>cannot be mended (%1)</source>
        <translation>修復できません (%1)</translation>
    </message>
    <message>
        <source>%1: the last line was cut short and is ignored</source>
        <translation>%1: 最後の行が途中で切れているため無視します</translation>
    </message>
    <message>
        <source>%1: the line is damaged and is ignored</source>
        <translation>%1: 行が壊れているため無視します</translation>
    </message>
    <message>
        <source>%1: the event is left out</source>
        <translation>%1: イベントを除きます</translation>
    </message>
    <message>
        <source>the case has no sessions</source>
        <translation>症例にセッションがありません</translation>
    </message>
    <message>
        <source>treat it first</source>
        <translation>先に治療を行ってください</translation>
    </message>
    <message>
        <source>there is no session %1</source>
        <translation>セッション %1 はありません</translation>
    </message>
    <message>
        <source>several sessions start with %1</source>
        <translation>%1 で始まるセッションが複数あります</translation>
    </message>
    <message>
        <source>this is no session</source>
        <translation>セッションではありません</translation>
    </message>
    <message>
        <source>choose one of the case&apos;s sessions</source>
        <translation>症例のセッションから選んでください</translation>
    </message>
    <message>
        <source>on_target, outside or lost was expected, not &apos;%1&apos;</source>
        <translation>on_target、outside、lost のいずれかが必要です。&apos;%1&apos; は使えません</translation>
    </message>
    <message>
        <source>open a case first</source>
        <translation>先に症例を開いてください</translation>
    </message>
    <message>
        <source>its first line names no columns frame and t_s</source>
        <translation>先頭行に列 frame と t_s がありません</translation>
    </message>
    <message>
        <source>begin a new session, or put the line back</source>
        <translation>新しいセッションを始めるか、行を元に戻してください</translation>
    </message>
    <message>
        <source>noted by an earlier version, without the coil&apos;s pose</source>
        <translation>以前のバージョンによる記録で、コイルの姿勢がありません</translation>
    </message>
    <message>
        <source>%1: the pulse is left out</source>
        <translation>%1: パルスを除きます</translation>
    </message>
    <message>
        <source>%1: the change is left out</source>
        <translation>%1: 変更を除きます</translation>
    </message>
    <message>
        <source>there is no pulse %1</source>
        <translation>パルス %1 はありません</translation>
    </message>
    <message>
        <source>the session has no pulses</source>
        <translation>セッションにパルスがありません</translation>
    </message>
    <message>
        <source>it has pulses %1 to %2</source>
        <translation>パルスは %1〜%2 です</translation>
    </message>
    <message>
        <source>%1 %2 %3 of pulse %4 is not possible</source>
        <translation>パルス %4 の %1 %2 %3 はあり得ません</translation>
    </message>
    <message>
        <source>0 to %1 %2 is expected</source>
        <translation>0〜%1 %2 が必要です</translation>
    </message>
    <message>
        <source>%1 is already excluded</source>
        <translation>%1 は既に除外されています</translation>
    </message>
    <message>
        <source>%1 is not excluded</source>
        <translation>%1 は除外されていません</translation>
    </message>
    <message>
        <source>%1 is excluded only with a reason</source>
        <translation>%1 の除外には理由が必要です</translation>
    </message>
    <message>
        <source>an MEP of</source>
        <translation>MEP</translation>
    </message>
    <message>
        <source>a latency of</source>
        <translation>潜時</translation>
    </message>
    <message>
        <source>session ended</source>
        <translation>セッション終了</translation>
    </message>
    <message>
        <source>session continued</source>
        <translation>セッション再開</translation>
    </message>
    <message>
        <source>a duration is not negative</source>
        <translation>時間は負になりません</translation>
    </message>
    <message>
        <source>the session&apos;s folder was removed</source>
        <translation>セッションのフォルダーが削除されています</translation>
    </message>
    <message>
        <source>has no column %1</source>
        <translation>列 %1 がありません</translation>
    </message>
    <message>
        <source>is this the right file?</source>
        <translation>正しいファイルですか?</translation>
    </message>
    <message>
        <source>%1: %2 line is damaged and is left out</source>
        <translation>%1: %2 行が壊れているため除きます</translation>
    </message>
    <message>
        <source>%1: %2 lines are damaged and are left out</source>
        <translation>%1: %2 行が壊れているため除きます</translation>
    </message>
    <message>
        <source>there are no poses to replay</source>
        <translation>再生する姿勢がありません</translation>
    </message>
    <message>
        <source>the session has none</source>
        <translation>セッションに姿勢がありません</translation>
    </message>
    <message>
        <source>choose a kept search</source>
        <translation>保存済みの測定を選んでください</translation>
    </message>
    <message>
        <source>this is no search for a threshold</source>
        <translation>閾値の測定ではありません</translation>
    </message>
    <message>
        <source>begin a new one</source>
        <translation>新しく始めてください</translation>
    </message>
    <message>
        <source>%1: the answer is left out</source>
        <translation>%1: 回答を除きます</translation>
    </message>
    <message>
        <source>there is no answer to take back</source>
        <translation>取り消せる回答がありません</translation>
    </message>
    <message>
        <source>twitch taken back</source>
        <translation>筋の反応を取り消しました</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>最後まで読み込めません</translation>
    </message>
    <message>
        <source>no name given: say who checked the case</source>
        <translation>氏名がありません: 症例を確認した人を入力してください</translation>
    </message>
    <message>
        <source>give a name or initials</source>
        <translation>氏名またはイニシャルを入力してください</translation>
    </message>
    <message>
        <source>the name of who checked it</source>
        <translation>確認者の氏名</translation>
    </message>
    <message>
        <source>the note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>%1 finding(s) are not acknowledged, the first: %2</source>
        <translation>%1 件の所見が未確認です。最初のもの: %2</translation>
    </message>
    <message>
        <source>look at each, then acknowledge them</source>
        <translation>それぞれを見てから確認してください</translation>
    </message>
    <message>
        <source>the case&apos;s files changed since they were shown</source>
        <translation>表示した後で症例のファイルが変わりました</translation>
    </message>
    <message>
        <source>open the case again and check it once more</source>
        <translation>症例を開き直し、もう一度確認してください</translation>
    </message>
    <message>
        <source>a correction of the brain is not saved</source>
        <translation>脳の修正が保存されていません</translation>
    </message>
    <message>
        <source>save or discard it first (window: Prepare, step 3)</source>
        <translation>先に保存または破棄してください (ウィンドウ: 準備、手順 3)</translation>
    </message>
    <message>
        <source>no name given: say who rejects the scan</source>
        <translation>氏名がありません: スキャンを却下する人を入力してください</translation>
    </message>
    <message>
        <source>no reason given: say why the scan is rejected</source>
        <translation>理由がありません: スキャンを却下する理由を入力してください</translation>
    </message>
    <message>
        <source>give it in a few words</source>
        <translation>短い言葉で入力してください</translation>
    </message>
    <message>
        <source>the name of who rejects</source>
        <translation>却下する人の氏名</translation>
    </message>
    <message>
        <source>the reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>an override needs a name and a reason</source>
        <translation>例外的な治療には氏名と理由が必要です</translation>
    </message>
    <message>
        <source>give both, or have the case checked</source>
        <translation>両方を入力するか、症例の確認を受けてください</translation>
    </message>
    <message>
        <source>the name of who overrides</source>
        <translation>例外を決定する人の氏名</translation>
    </message>
    <message>
        <source>the folder of cases cannot be read (%1)</source>
        <translation>症例のフォルダーを読み込めません (%1)</translation>
    </message>
    <message>
        <source>the map of the skin&apos;s fit could not be written</source>
        <translation>皮膚の適合のマップを書き込めませんでした</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Coordinate system</translation>
    </message>
    <message>
        <source>Created by</source>
        <translation>Created by</translation>
    </message>
    <message>
        <source>names a second coordinate system, &apos;%1&apos;</source>
        <translation>2 つ目の座標系 &apos;%1&apos; を示しています</translation>
    </message>
    <message>
        <source>import each part as a file of its own</source>
        <translation>それぞれを別のファイルとして取り込んでください</translation>
    </message>
    <message>
        <source>Session Name</source>
        <translation>Session Name</translation>
    </message>
    <message>
        <source>Stim. Power A</source>
        <translation>Stim. Power A</translation>
    </message>
    <message>
        <source>Dist. to Target</source>
        <translation>Dist. to Target</translation>
    </message>
    <message>
        <source>Target Error</source>
        <translation>Target Error</translation>
    </message>
    <message>
        <source>Angular Error</source>
        <translation>Angular Error</translation>
    </message>
    <message>
        <source>Twist Error</source>
        <translation>Twist Error</translation>
    </message>
    <message>
        <source>Creation Cause</source>
        <translation>Creation Cause</translation>
    </message>
    <message>
        <source>Crosshairs Driver</source>
        <translation>Crosshairs Driver</translation>
    </message>
    <message>
        <source>Target Name</source>
        <translation>Target Name</translation>
    </message>
    <message>
        <source>Sample Name</source>
        <translation>Sample Name</translation>
    </message>
    <message>
        <source>Electrode Name</source>
        <translation>Electrode Name</translation>
    </message>
    <message>
        <source>Planned Landmark Name</source>
        <translation>Planned Landmark Name</translation>
    </message>
    <message>
        <source>the file has no pose for it</source>
        <translation>ファイルにその姿勢がありません</translation>
    </message>
    <message>
        <source>needs the T1 for its coordinate system &apos;Brainsight&apos;</source>
        <translation>座標系 &apos;Brainsight&apos; のため T1 が必要です</translation>
    </message>
    <message>
        <source>its system &apos;Brainsight&apos; was converted by the case&apos;s T1; no published image confirms the origin: compare one target</source>
        <translation>座標系 &apos;Brainsight&apos; は症例の T1 で変換しました。原点を確認できる公開画像はありません: 標的 1 つを比べてください</translation>
    </message>
    <message>
        <source>its line &apos;# Version:&apos; is missing</source>
        <translation>行 &apos;# Version:&apos; がありません</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>もう一度書き出してください</translation>
    </message>
    <message>
        <source>is Brainsight&apos;s version %1; 7 to 15 are read</source>
        <translation>Brainsight のバージョン %1 です。読めるのは 7〜15 です</translation>
    </message>
    <message>
        <source>its line &apos;# Coordinate system:&apos; is missing</source>
        <translation>行 &apos;# Coordinate system:&apos; がありません</translation>
    </message>
    <message>
        <source>Brainsight text export, version %1, %2</source>
        <translation>Brainsight テキスト書き出し、バージョン %1、%2</translation>
    </message>
    <message>
        <source># Coordinate system</source>
        <translation># Coordinate system</translation>
    </message>
    <message>
        <source># Target Name	</source>
        <translation># Target Name	</translation>
    </message>
    <message>
        <source># Sample Name	</source>
        <translation># Sample Name	</translation>
    </message>
    <message>
        <source># Electrode Name	</source>
        <translation># Electrode Name	</translation>
    </message>
    <message>
        <source>its columns Loc. X to m2n2 are missing</source>
        <translation>列 Loc. X から m2n2 までがありません</translation>
    </message>
    <message>
        <source>has %1 cells, its section has %2 columns</source>
        <translation>%1 個の欄がありますが、その節の列は %2 個です</translation>
    </message>
    <message>
        <source>is cut short</source>
        <translation>途中で切れています</translation>
    </message>
    <message>
        <source>%1 pulses without a pose are left out: readers of Brainsight&apos;s text stop at them</source>
        <translation>姿勢のないパルス %1 回を除きます: Brainsight のテキストを読むプログラムがそこで止まるためです</translation>
    </message>
    <message>
        <source># Target Name	%1</source>
        <translation># Target Name	%1</translation>
    </message>
    <message>
        <source>sform and qform of the T1 lie up to %1 mm apart; the file is in the %2</source>
        <translation>T1 の sform と qform が最大 %1 mm ずれています。ファイルは %2 で書かれます</translation>
    </message>
    <message>
        <source>its coordinates are %1, a template&apos;s and not this patient&apos;s: export it in the T1&apos;s own space</source>
        <translation>座標が %1、つまりテンプレートのもので、この患者のものではありません: T1 自身の空間で書き出してください</translation>
    </message>
    <message>
        <source>its coordinates are of no stated space, of which RAS or LPS is not certain: give --space lps or --space ras</source>
        <translation>座標の空間が書かれておらず、RAS か LPS か確定できません: 「座標」で RAS か LPS を選んでください</translation>
    </message>
    <message>
        <source>its coordinates are &apos;%1&apos;, of which RAS or LPS is not certain: give --space lps or --space ras</source>
        <translation>座標が &apos;%1&apos; で、RAS か LPS か確定できません: 「座標」で RAS か LPS を選んでください</translation>
    </message>
    <message>
        <source>corners up to %1 apart</source>
        <translation>角のずれは最大 %1</translation>
    </message>
    <message>
        <source>its T1 is another one: %1 x %2 x %3 voxels, the case&apos;s has %4 x %5 x %6</source>
        <translation>T1 が別のものです: %1 x %2 x %3 ボクセル、症例は %4 x %5 x %6</translation>
    </message>
    <message>
        <source>its T1 has other voxel sizes than the case&apos;s%1</source>
        <translation>T1 のボクセルの大きさが症例と異なります%1</translation>
    </message>
    <message>
        <source>its T1 has the case&apos;s voxels in another world, corners up to %1 apart: poses are moved by it</source>
        <translation>T1 のボクセルは症例と同じですが、世界座標が異なり、角が最大 %1 ずれています: その分だけ姿勢が移動します</translation>
    </message>
    <message>
        <source>it belongs to another T1: by its qform the corners lie up to %1 from the case&apos;s; name the T1 with --t1</source>
        <translation>別の T1 のものです: qform では角が症例から最大 %1 ずれています。「T1」でその T1 を選んでください</translation>
    </message>
    <message>
        <source>sform and qform of this T1 differed when the case was prepared: name that T1 with --t1, and its form with --form if the file says none</source>
        <translation>症例の準備時に、この T1 の sform と qform が異なっていました: 「T1」でその T1 を選び、ファイルに指定がなければ「変換」も選んでください</translation>
    </message>
    <message>
        <source>sform and qform of the T1 lie up to %1 apart</source>
        <translation>T1 の sform と qform が最大 %1 ずれています</translation>
    </message>
    <message>
        <source>%1 and the file does not say which it means: give --form sform or --form qform</source>
        <translation>%1。ファイルにどちらかの指定がありません: 「変換」で sform か qform を選んでください</translation>
    </message>
    <message>
        <source>%1; the %2 is taken</source>
        <translation>%1。%2 を使います</translation>
    </message>
    <message>
        <source>its frame is that of nasion and ears, and the case has no landmarks: set them first (plan)</source>
        <translation>座標系が鼻根点と両耳によるものですが、症例にランドマークがありません: 先に設定してください (計画)</translation>
    </message>
    <message>
        <source>its frame is that of nasion and ears, and the file does not say where its x points: give --head-frame x-nasion or --head-frame x-right</source>
        <translation>座標系が鼻根点と両耳によるものですが、x の向きがファイルに書かれていません: 「頭部座標系」で 1 つ選んでください</translation>
    </message>
    <message>
        <source>its frame is made from the case&apos;s nasion and tragi, x to the nasion; the file holds no landmarks, so no residual can be stated</source>
        <translation>座標系は症例の鼻根点と両耳珠から作りました (x は鼻根点へ)。ファイルにランドマークがないため、残差は示せません</translation>
    </message>
    <message>
        <source>its frame is made from the case&apos;s nasion and tragi, x to the right ear; the file holds no landmarks, so no residual can be stated</source>
        <translation>座標系は症例の鼻根点と両耳珠から作りました (x は右耳へ)。ファイルにランドマークがないため、残差は示せません</translation>
    </message>
    <message>
        <source>nasion and ears of the file fit those of the case to %1 mm</source>
        <translation>ファイルの鼻根点と両耳は、症例のものと %1 mm の残差で合います</translation>
    </message>
    <message>
        <source>%1; at most %2 mm are taken</source>
        <translation>%1。許容は %2 mm までです</translation>
    </message>
    <message>
        <source>its handle points %1</source>
        <translation>ハンドルが%1向いています</translation>
    </message>
    <message>
        <source>its centre lies %1 from the middle of the head</source>
        <translation>中心が頭部の中央から %1 離れています</translation>
    </message>
    <message>
        <source>its axis points out of the head: compare it with the other program</source>
        <translation>軸が頭部の外を向いています: ほかのプログラムと比べてください</translation>
    </message>
    <message>
        <source>its centre lies %1 from the skin</source>
        <translation>中心が皮膚から %1 離れています</translation>
    </message>
    <message>
        <source>its place is no finite number</source>
        <translation>位置が有限の数値ではありません</translation>
    </message>
    <message>
        <source>it lies farther than 40 cm from the middle of the head</source>
        <translation>頭部の中央から 40 cm を超えて離れています</translation>
    </message>
    <message>
        <source>as %1 its poses lie %2 mm from the skin, as %3 %4 mm: say with --space ras or --space lps which it is</source>
        <translation>%1 とすると姿勢は皮膚から %2 mm、%3 とすると %4 mm です: 「座標」で RAS か LPS を選んでください</translation>
    </message>
    <message>
        <source>half of its places lie more than %1 from the skin: its frame may have other axes</source>
        <translation>半数の位置が皮膚から %1 を超えて離れています: 座標軸が異なる可能性があります</translation>
    </message>
    <message>
        <source>its pose holds something that is no finite number</source>
        <translation>姿勢に有限でない数値があります</translation>
    </message>
    <message>
        <source>its pose lies farther away than 100 m</source>
        <translation>姿勢が 100 m を超えて離れています</translation>
    </message>
    <message>
        <source>the last row of its matrix is not 0 0 0 1</source>
        <translation>行列の最終行が 0 0 0 1 ではありません</translation>
    </message>
    <message>
        <source>its axes are left-handed (determinant %1), an error of the program that wrote it</source>
        <translation>座標軸が左手系です (行列式 %1)。書き出したプログラムの誤りです</translation>
    </message>
    <message>
        <source>its %1 axis has the length %2 instead of 1</source>
        <translation>%1 軸の長さが 1 ではなく %2 です</translation>
    </message>
    <message>
        <source>its axes are %1 deg from right angles</source>
        <translation>座標軸が直角から %1 deg ずれています</translation>
    </message>
    <message>
        <source>its axes were made unit and orthogonal (off by %1)</source>
        <translation>座標軸を単位長で直交に直しました (ずれ %1)</translation>
    </message>
    <message>
        <source>taken as %1 as asked, the file says %2</source>
        <translation>指定どおり %1 として扱います。ファイルの指定は %2 です</translation>
    </message>
    <message>
        <source>the handle is turned by 180 degrees, as asked</source>
        <translation>指定どおり、ハンドルを 180 度回しました</translation>
    </message>
    <message>
        <source>the handle is taken as written, as asked</source>
        <translation>指定どおり、ハンドルは記載のままです</translation>
    </message>
    <message>
        <source>holds more than 100000 files</source>
        <translation>100000 個を超えるファイルがあります</translation>
    </message>
    <message>
        <source>choose a folder in it, or one file</source>
        <translation>その中のフォルダー、または 1 つのファイルを選んでください</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>フォルダーを読み込めません: %1</translation>
    </message>
    <message>
        <source>is larger than 64 MB, which no list of targets is</source>
        <translation>64 MB を超えています。標的の一覧ではありません</translation>
    </message>
    <message>
        <source>holds no file of a navigator that FaceNav knows</source>
        <translation>FaceNav が読めるナビゲーターのファイルがありません</translation>
    </message>
    <message>
        <source>the manual&apos;s page on other programs lists them</source>
        <translation>マニュアルのほかのプログラムのページに一覧があります</translation>
    </message>
    <message>
        <source>holds %1 files that could be meant: %2</source>
        <translation>候補となるファイルが %1 個あります: %2</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>1 つ選んでください</translation>
    </message>
    <message>
        <source>holds %1 sessions: %2</source>
        <translation>%1 個のセッションがあります: %2</translation>
    </message>
    <message>
        <source>choose the folder of one</source>
        <translation>1 つのフォルダーを選んでください</translation>
    </message>
    <message>
        <source>holds several data sets of NIBS-BIDS</source>
        <translation>NIBS-BIDS のデータセットが複数あります</translation>
    </message>
    <message>
        <source>is an HDF5 file: save a .mat as version 7 or older, a transform as .tfm</source>
        <translation>HDF5 ファイルです: .mat はバージョン 7 以前、変換は .tfm として保存してください</translation>
    </message>
    <message>
        <source>is a .mat of version 7.3: save it with &apos;-v7&apos;</source>
        <translation>バージョン 7.3 の .mat です: &apos;-v7&apos; で保存してください</translation>
    </message>
    <message>
        <source>is text in UTF-16: save it as UTF-8</source>
        <translation>UTF-16 のテキストです: UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>SQLite format 3</source>
        <translation>SQLite format 3</translation>
    </message>
    <message>
        <source>is a database, perhaps a Brainsight project: export its targets as text</source>
        <translation>データベースです。Brainsight のプロジェクトかもしれません: 標的をテキストで書き出してください</translation>
    </message>
    <message>
        <source>is an archive without a session: unpack it and choose the file in it</source>
        <translation>セッションのないアーカイブファイルです: 展開して、その中のファイルを選んでください</translation>
    </message>
    <message>
        <source>is a table of events, perhaps of NIBS-BIDS: choose the folder or its markers.tsv</source>
        <translation>イベントの表です。NIBS-BIDS かもしれません: フォルダー、またはその markers.tsv を選んでください</translation>
    </message>
    <message>
        <source>is a Brainsight stream of poses without targets or pulses</source>
        <translation>標的もパルスもない Brainsight の姿勢ストリームです</translation>
    </message>
    <message>
        <source>Brainsight text export, version 12: targets, pulses, landmarks</source>
        <translation>Brainsight テキスト書き出し、バージョン 12: 標的、パルス、ランドマーク</translation>
    </message>
    <message>
        <source>Localite InstrumentMarker; with --session TriggerMarkers</source>
        <translation>Localite InstrumentMarker; セッションを選んだとき TriggerMarkers</translation>
    </message>
    <message>
        <source>SimNIBS session for the simulation of all targets</source>
        <translation>すべての標的のシミュレーション用 SimNIBS セッション</translation>
    </message>
    <message>
        <source>SimNIBS script for the simulation of all targets</source>
        <translation>すべての標的のシミュレーション用 SimNIBS スクリプト</translation>
    </message>
    <message>
        <source>ANT visor2 markers, tied to the T1</source>
        <translation>ANT visor2 のマーカー (T1 に結び付き)</translation>
    </message>
    <message>
        <source>InVesalius markers, version 5</source>
        <translation>InVesalius のマーカー、バージョン 5</translation>
    </message>
    <message>
        <source>3D Slicer markups</source>
        <translation>3D Slicer のマークアップ</translation>
    </message>
    <message>
        <source>transform of one target for 3D Slicer and ITK</source>
        <translation>3D Slicer と ITK 用の標的 1 つの変換</translation>
    </message>
    <message>
        <source>older markups of 3D Slicer</source>
        <translation>3D Slicer の旧マークアップ</translation>
    </message>
    <message>
        <source>NaviNIBS targets; with --session samples</source>
        <translation>NaviNIBS の標的; セッションを選んだとき samples</translation>
    </message>
    <message>
        <source>StimGuide: places and pulses</source>
        <translation>StimGuide: 位置とパルス</translation>
    </message>
    <message>
        <source>ANT visor2&apos;s list of pulses</source>
        <translation>ANT visor2 のパルス一覧</translation>
    </message>
    <message>
        <source>a folder of NIBS-BIDS: targets, pulses, T1</source>
        <translation>NIBS-BIDS のフォルダー: 標的、パルス、T1</translation>
    </message>
    <message>
        <source>targets and pulses as a table</source>
        <translation>標的とパルスの表</translation>
    </message>
    <message>
        <source>targets as in targets.json</source>
        <translation>targets.json と同じ形式の標的</translation>
    </message>
    <message>
        <source>%1 targets stand in it twice with one pose and count once</source>
        <translation>%1 個の標的が同じ姿勢で 2 回書かれており、1 回と数えます</translation>
    </message>
    <message>
        <source>holds more than 100000 items</source>
        <translation>100000 個を超える項目があります</translation>
    </message>
    <message>
        <source>holds no targets, pulses or landmarks (%1)</source>
        <translation>標的もパルスもランドマークもありません (%1)</translation>
    </message>
    <message>
        <source>another template</source>
        <translation>別のテンプレート</translation>
    </message>
    <message>
        <source>no such format: %1</source>
        <translation>その形式はありません: %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>次のいずれかです: %1</translation>
    </message>
    <message>
        <source>is no file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>空です</translation>
    </message>
    <message>
        <source>its numbers have decimal commas</source>
        <translation>小数点にコンマが使われています</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>小数点にピリオドを使って書き出してください</translation>
    </message>
    <message>
        <source>is no file of a navigator that FaceNav knows</source>
        <translation>FaceNav が読めるナビゲーターのファイルではありません</translation>
    </message>
    <message>
        <source>there is no target to export</source>
        <translation>書き出す標的がありません</translation>
    </message>
    <message>
        <source>plan one first</source>
        <translation>先に計画してください</translation>
    </message>
    <message>
        <source>%1 pulses are left out: %2 holds targets only</source>
        <translation>パルス %1 回を除きます: %2 に入るのは標的だけです</translation>
    </message>
    <message>
        <source>to the %1 of the head</source>
        <translation>頭部の %1 へ</translation>
    </message>
    <message>
        <source>to the %1 and %2 of the head</source>
        <translation>頭部の %1 と %2 へ</translation>
    </message>
    <message>
        <source>as written its handle points %1, flipped %2: give --y-sign as-written or --y-sign flipped</source>
        <translation>記載どおりならハンドルは%1、逆向きなら%2を向きます: 「ハンドル」で 1 つ選んでください</translation>
    </message>
    <message>
        <source>the marker has no orientation</source>
        <translation>マーカーに向きがありません</translation>
    </message>
    <message>
        <source>is of a version of InVesalius&apos;s markers that is not read</source>
        <translation>読み込めないバージョンの InVesalius マーカーです</translation>
    </message>
    <message>
        <source>0 to 5 are</source>
        <translation>読めるのは 0〜5 です</translation>
    </message>
    <message>
        <source>needs the T1: its places are those of the image</source>
        <translation>T1 が必要です: 位置は画像の座標です</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>もう一度コピーするか、書き出してください</translation>
    </message>
    <message>
        <source>its column &apos;%1&apos; is missing</source>
        <translation>列 &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>InVesalius markers, version %1</source>
        <translation>InVesalius のマーカー、バージョン %1</translation>
    </message>
    <message>
        <source>its places are those of the image: taken as the case&apos;s T1</source>
        <translation>位置は画像の座標です: 症例の T1 のものとして扱います</translation>
    </message>
    <message>
        <source>names are UTF-8; InVesalius on Windows may show other letters</source>
        <translation>名前は UTF-8 です。Windows 版の InVesalius では文字化けすることがあります</translation>
    </message>
    <message>
        <source>InVesalius&apos;s file</source>
        <translation>InVesalius のファイル</translation>
    </message>
    <message>
        <source>#Insight Transform File</source>
        <translation>#Insight Transform File</translation>
    </message>
    <message>
        <source>ITK transform, LPS, from the parent</source>
        <translation>ITK 変換、LPS、親から</translation>
    </message>
    <message>
        <source>is a transform of type &apos;%1&apos;</source>
        <translation>種類 &apos;%1&apos; の変換です</translation>
    </message>
    <message>
        <source>save an affine one</source>
        <translation>アフィン変換で保存してください</translation>
    </message>
    <message>
        <source>has %1 numbers, 12 were expected</source>
        <translation>%1 個の数値がありますが、12 個が必要です</translation>
    </message>
    <message>
        <source>copy or save it again</source>
        <translation>もう一度コピーするか、保存してください</translation>
    </message>
    <message>
        <source>its line &apos;Parameters:&apos; is missing</source>
        <translation>行 &apos;Parameters:&apos; がありません</translation>
    </message>
    <message>
        <source>is cut short: its line &apos;FixedParameters:&apos; is missing</source>
        <translation>途中で切れています: 行 &apos;FixedParameters:&apos; がありません</translation>
    </message>
    <message>
        <source>a transform holds no name: the file&apos;s is taken</source>
        <translation>変換には名前がありません: ファイル名を使います</translation>
    </message>
    <message>
        <source>holds one target, the case has %1</source>
        <translation>入る標的は 1 つですが、症例には %1 個あります</translation>
    </message>
    <message>
        <source>choose one with --target NAME</source>
        <translation>標的 1 つにチェックを入れてください</translation>
    </message>
    <message>
        <source>a transform holds no name: the file&apos;s name stands for &apos;%1&apos;</source>
        <translation>変換には名前がありません: ファイル名が &apos;%1&apos; を表します</translation>
    </message>
    <message>
        <source>is no list of four rows</source>
        <translation>4 行のリストではありません</translation>
    </message>
    <message>
        <source>has a row that is no list of four numbers</source>
        <translation>4 個の数値のリストでない行があります</translation>
    </message>
    <message>
        <source>the file has no matrix for it</source>
        <translation>ファイルにその行列がありません</translation>
    </message>
    <message>
        <source>not tracked: its rotation is the identity</source>
        <translation>追跡なし: 回転が恒等変換です</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未設定</translation>
    </message>
    <message>
        <source>element %1 is a &apos;%2&apos; and is left out</source>
        <translation>要素 %1 は &apos;%2&apos; なので除きます</translation>
    </message>
    <message>
        <source>its name holds no date: the pulses have times of day only</source>
        <translation>ファイル名に日付がありません: パルスには時刻だけがあります</translation>
    </message>
    <message>
        <source>its root element is &apos;%1&apos;, a list of Localite&apos;s markers was expected</source>
        <translation>ルート要素が &apos;%1&apos; です。Localite のマーカーの一覧が必要です</translation>
    </message>
    <message>
        <source>targets are in another file of Localite: export without --session</source>
        <translation>標的は Localite の別のファイルに入ります: セッションを選ばずに書き出してください</translation>
    </message>
    <message>
        <source>Localite takes the date of pulses from the file&apos;s name: TriggerMarkers_Coil0_%1.xml</source>
        <translation>Localite はパルスの日付をファイル名から読みます: TriggerMarkers_Coil0_%1.xml</translation>
    </message>
    <message>
        <source>Localite and SimNIBS want the file name InstrumentMarker and 17 digits, as InstrumentMarker%1.xml</source>
        <translation>Localite と SimNIBS では、ファイル名が InstrumentMarker と 17 桁の数字でなければなりません。例: InstrumentMarker%1.xml</translation>
    </message>
    <message>
        <source>a save of it was left out: %1</source>
        <translation>その保存の 1 つを除きました: %1</translation>
    </message>
    <message>
        <source>%1 pulses have the pose of coil 2</source>
        <translation>%1 回のパルスがコイル 2 の姿勢を持っています</translation>
    </message>
    <message>
        <source>both coils have a pose at %1 pulses, and each comes in as one</source>
        <translation>%1 回のパルスで両方のコイルに姿勢があり、それぞれ 1 回として取り込みます</translation>
    </message>
    <message>
        <source>its lists lie in &apos;%1&apos; and in &apos;%2&apos;</source>
        <translation>一覧が &apos;%1&apos; と &apos;%2&apos; に分かれています</translation>
    </message>
    <message>
        <source>choose one file</source>
        <translation>1 つのファイルを選んでください</translation>
    </message>
    <message>
        <source>%1 is the fullest of %2 saves: %3 entries</source>
        <translation>%2 個の保存のうち %1 が最も多くを含みます: %3 件</translation>
    </message>
    <message>
        <source>Localite session</source>
        <translation>Localite のセッション</translation>
    </message>
    <message>
        <source>Localite session, %1</source>
        <translation>Localite のセッション、%1</translation>
    </message>
    <message>
        <source>is cut short or damaged</source>
        <translation>途中で切れているか、壊れています</translation>
    </message>
    <message>
        <source>MATLAB 5.0 MAT-file, written by FaceNav</source>
        <translation>MATLAB 5.0 MAT-file, written by FaceNav</translation>
    </message>
    <message>
        <source>the file has no coilToMRITransf for it</source>
        <translation>ファイルにその coilToMRITransf がありません</translation>
    </message>
    <message>
        <source>NaviNIBS computes its pose and did not store it: &apos;facenav target&apos; plans one at this place</source>
        <translation>NaviNIBS が姿勢を計算しますが、保存されていません: この場所に標的を作るには、計画の画面で座標を入力してください</translation>
    </message>
    <message>
        <source>targets are in another file of NaviNIBS: export without --session</source>
        <translation>標的は NaviNIBS の別のファイルに入ります: セッションを選ばずに書き出してください</translation>
    </message>
    <message>
        <source>is a NaviNIBS session of version &apos;%1&apos;; 0.0.1 and 0.0.2 are read</source>
        <translation>バージョン &apos;%1&apos; の NaviNIBS セッションです。読めるのは 0.0.1 と 0.0.2 です</translation>
    </message>
    <message>
        <source>export its targets as .json</source>
        <translation>標的を .json で書き出してください</translation>
    </message>
    <message>
        <source>names a file that is not there: %1</source>
        <translation>存在しないファイルを示しています: %1</translation>
    </message>
    <message>
        <source>the file gives no directions of the coil for it</source>
        <translation>ファイルにコイルの向きがありません</translation>
    </message>
    <message>
        <source>the file gives no centre of the coil for it</source>
        <translation>ファイルにコイルの中心がありません</translation>
    </message>
    <message>
        <source>has the position &apos;%1&apos; a second time</source>
        <translation>位置 &apos;%1&apos; が 2 回あります</translation>
    </message>
    <message>
        <source>give each row an id of its own</source>
        <translation>各行に固有の id を付けてください</translation>
    </message>
    <message>
        <source>pulse at %1</source>
        <translation>%1 のパルス</translation>
    </message>
    <message>
        <source>%1 pulses stand for a train each, and come in at its start</source>
        <translation>パルス %1 回はそれぞれ 1 トレインを表し、その開始時刻で取り込みます</translation>
    </message>
    <message>
        <source>its position &apos;%1&apos; is no whole pose</source>
        <translation>位置 &apos;%1&apos; の姿勢が完全ではありません</translation>
    </message>
    <message>
        <source>not tracked: it names no position</source>
        <translation>追跡なし: 位置の指定がありません</translation>
    </message>
    <message>
        <source>its position &apos;%1&apos; is not in markers.tsv</source>
        <translation>位置 &apos;%1&apos; が markers.tsv にありません</translation>
    </message>
    <message>
        <source>its runs have other coordinate systems: %1 and %2</source>
        <translation>ラン間で座標系が異なります: %1 と %2</translation>
    </message>
    <message>
        <source>choose the markers.tsv of one run</source>
        <translation>1 つのランの markers.tsv を選んでください</translation>
    </message>
    <message>
        <source>it is intended for &apos;%1&apos;, which is not beside it: its world is taken as that of the case&apos;s T1</source>
        <translation>対象の &apos;%1&apos; が同じ場所にありません: 世界座標は症例の T1 のものとして扱います</translation>
    </message>
    <message>
        <source>holds %1 people: %2</source>
        <translation>%1 人分を含んでいます: %2</translation>
    </message>
    <message>
        <source>y points away from the handle</source>
        <translation>y points away from the handle</translation>
    </message>
    <message>
        <source>World of the T1 named in IntendedFor: RAS mm. element_centre is the middle of the coil&apos;s contact face; the directions are the columns of SimNIBS&apos;s matsimnibs: z points into the head</source>
        <translation>World of the T1 named in IntendedFor: RAS mm. element_centre is the middle of the coil&apos;s contact face; the directions are the columns of SimNIBS&apos;s matsimnibs: z points into the head</translation>
    </message>
    <message>
        <source>place of a coil; events.tsv refers to it</source>
        <translation>place of a coil; events.tsv refers to it</translation>
    </message>
    <message>
        <source>the coil, as in ElementSet of nibs.json</source>
        <translation>the coil, as in ElementSet of nibs.json</translation>
    </message>
    <message>
        <source>name of the planned target; of a pulse, its target</source>
        <translation>name of the planned target; of a pulse, its target</translation>
    </message>
    <message>
        <source>target: a planned place; pulse: where the coil was at one pulse</source>
        <translation>target: a planned place; pulse: where the coil was at one pulse</translation>
    </message>
    <message>
        <source>middle of the coil&apos;s contact face</source>
        <translation>middle of the coil&apos;s contact face</translation>
    </message>
    <message>
        <source>direction into the head</source>
        <translation>direction into the head</translation>
    </message>
    <message>
        <source>direction away from the handle: the handle points the other way</source>
        <translation>direction away from the handle: the handle points the other way</translation>
    </message>
    <message>
        <source>point on the cortex that is aimed at</source>
        <translation>point on the cortex that is aimed at</translation>
    </message>
    <message>
        <source>name of the target</source>
        <translation>name of the target</translation>
    </message>
    <message>
        <source>time of the pulse since the first one of the session</source>
        <translation>time of the pulse since the first one of the session</translation>
    </message>
    <message>
        <source>0: a single pulse</source>
        <translation>0: a single pulse</translation>
    </message>
    <message>
        <source>row of nibs.tsv</source>
        <translation>row of nibs.tsv</translation>
    </message>
    <message>
        <source>row of markers.tsv; n/a: head or coil was not seen</source>
        <translation>row of markers.tsv; n/a: head or coil was not seen</translation>
    </message>
    <message>
        <source>peak-to-peak of the motor evoked potential</source>
        <translation>peak-to-peak of the motor evoked potential</translation>
    </message>
    <message>
        <source>on_target, outside (of the tolerance) or lost (no pose)</source>
        <translation>on_target, outside (of the tolerance) or lost (no pose)</translation>
    </message>
    <message>
        <source>yes: excluded when the session was reviewed</source>
        <translation>yes: excluded when the session was reviewed</translation>
    </message>
    <message>
        <source>kind of pulse</source>
        <translation>kind of pulse</translation>
    </message>
    <message>
        <source>TMS: transcranial magnetic stimulation</source>
        <translation>TMS: transcranial magnetic stimulation</translation>
    </message>
    <message>
        <source>as in StimulatorSet</source>
        <translation>as in StimulatorSet</translation>
    </message>
    <message>
        <source>as in ElementSet</source>
        <translation>as in ElementSet</translation>
    </message>
    <message>
        <source>n/a: not known to the navigation</source>
        <translation>n/a: not known to the navigation</translation>
    </message>
    <message>
        <source>strength that the stimulator was set to</source>
        <translation>strength that the stimulator was set to</translation>
    </message>
    <message>
        <source>% Maximum Stimulator Output</source>
        <translation>% Maximum Stimulator Output</translation>
    </message>
    <message>
        <source>pulses of one event</source>
        <translation>pulses of one event</translation>
    </message>
    <message>
        <source>NAS nasion, INI inion, LT and RT left and right tragus (not the preauricular points)</source>
        <translation>NAS nasion, INI inion, LT and RT left and right tragus (not the preauricular points)</translation>
    </message>
    <message>
        <source>single pulses of transcranial magnetic stimulation, navigated by FaceNav</source>
        <translation>single pulses of transcranial magnetic stimulation, navigated by FaceNav</translation>
    </message>
    <message>
        <source>Transcranial magnetic stimulation navigated by FaceNav</source>
        <translation>Transcranial magnetic stimulation navigated by FaceNav</translation>
    </message>
    <message>
        <source>label of the person</source>
        <translation>label of the person</translation>
    </message>
    <message>
        <source>%1 pulses have no time: their onset is n/a</source>
        <translation>%1 回のパルスに時刻がありません: onset は n/a になります</translation>
    </message>
    <message>
        <source>there is no target and no pulse to export</source>
        <translation>書き出す標的もパルスもありません</translation>
    </message>
    <message>
        <source>the T1 shows the person&apos;s face: README says so</source>
        <translation>T1 に本人の顔が写っています: README に明記しています</translation>
    </message>
    <message>
        <source>state NIBSCoordinateUnits as mm, cm or m in its coordsystem.json</source>
        <translation>coordsystem.json の NIBSCoordinateUnits に mm、cm、m のいずれかを書いてください</translation>
    </message>
    <message>
        <source>its unit is &apos;%1&apos; by coordsystem.json and &apos;%2&apos; by markers.json</source>
        <translation>単位が coordsystem.json では &apos;%1&apos;、markers.json では &apos;%2&apos; です</translation>
    </message>
    <message>
        <source>the unit of its coordinates is not stated</source>
        <translation>座標の単位が書かれていません</translation>
    </message>
    <message>
        <source>has %1 cells, the header %2</source>
        <translation>%1 個の欄がありますが、見出しは %2 個です</translation>
    </message>
    <message>
        <source>no pose</source>
        <translation>姿勢なし</translation>
    </message>
    <message>
        <source>table of FaceNav</source>
        <translation>FaceNav の表</translation>
    </message>
    <message>
        <source>has %1 fields, the header %2</source>
        <translation>%1 個の欄がありますが、見出しは %2 個です</translation>
    </message>
    <message>
        <source>targets.json of FaceNav</source>
        <translation>FaceNav の targets.json</translation>
    </message>
    <message>
        <source>poslist %1, pos %2</source>
        <translation>poslist %1、pos %2</translation>
    </message>
    <message>
        <source>it has no matsimnibs: simulate it once, SimNIBS then writes it</source>
        <translation>matsimnibs がありません: SimNIBS で一度シミュレーションすると書き込まれます</translation>
    </message>
    <message>
        <source>holds no session of SimNIBS: &apos;poslist&apos; is missing</source>
        <translation>SimNIBS のセッションがありません: &apos;poslist&apos; がありません</translation>
    </message>
    <message>
        <source>a list of type %1 is left out</source>
        <translation>種類 %1 の一覧を除きます</translation>
    </message>
    <message>
        <source>set subpath and fnamecoil in SimNIBS: the case knows neither m2m folder nor coil file</source>
        <translation>SimNIBS で subpath と fnamecoil を設定してください: 症例には m2m フォルダーもコイルのファイルもありません</translation>
    </message>
    <message>
        <source>begins with &apos;%1&apos;, which is no type of SimNIBS&apos;s</source>
        <translation>先頭が &apos;%1&apos; です。SimNIBS の種類ではありません</translation>
    </message>
    <message>
        <source>the script</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;, LPS or RAS was expected</source>
        <translation>&apos;%1&apos; です。LPS か RAS が必要です</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;, mm was expected</source>
        <translation>&apos;%1&apos; です。mm が必要です</translation>
    </message>
    <message>
        <source>its position is missing</source>
        <translation>位置がありません</translation>
    </message>
    <message>
        <source>its position is %1</source>
        <translation>位置が %1 です</translation>
    </message>
    <message>
        <source>list %1, point %2</source>
        <translation>一覧 %1、点 %2</translation>
    </message>
    <message>
        <source>coil pose</source>
        <translation>コイルの姿勢</translation>
    </message>
    <message>
        <source>Slicer&apos;s file</source>
        <translation>Slicer のファイル</translation>
    </message>
    <message>
        <source># Markups fiducial file</source>
        <translation># Markups fiducial file</translation>
    </message>
    <message>
        <source>3D Slicer markups (.fcsv)</source>
        <translation>3D Slicer のマークアップ (.fcsv)</translation>
    </message>
    <message>
        <source>an .fcsv holds places without the coil&apos;s orientation</source>
        <translation>.fcsv にはコイルの向きがなく、位置だけが入ります</translation>
    </message>
    <message>
        <source>SofTaxic&apos;s file</source>
        <translation>SofTaxic のファイル</translation>
    </message>
    <message>
        <source>the file has no position for it</source>
        <translation>ファイルにその位置がありません</translation>
    </message>
    <message>
        <source>is empty: its places have no frame</source>
        <translation>空です: 位置の座標系がありません</translation>
    </message>
    <message>
        <source>nasion and ears</source>
        <translation>鼻根点と両耳</translation>
    </message>
    <message>
        <source>the T1 has no sform</source>
        <translation>T1 に sform がありません</translation>
    </message>
    <message>
        <source>the T1 has no qform</source>
        <translation>T1 に qform がありません</translation>
    </message>
    <message>
        <source>name the T1 that the other program used with --t1</source>
        <translation>ほかのプログラムが使った T1 を「T1」で選んでください</translation>
    </message>
    <message>
        <source>a place only: how the axes of the program&apos;s coil lie is not documented</source>
        <translation>位置のみ: そのプログラムのコイルの軸の向きは公開されていません</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;, &apos;%2&apos; was expected</source>
        <translation>&apos;%1&apos; です。&apos;%2&apos; が必要です</translation>
    </message>
    <message>
        <source>marker %1 has no pose of a coil and is left out</source>
        <translation>マーカー %1 にはコイルの姿勢がないので除きます</translation>
    </message>
    <message>
        <source>the T1 has no qform, which ties a file of visor2 to its image</source>
        <translation>T1 に、visor2 のファイルと画像を結び付ける qform がありません</translation>
    </message>
    <message>
        <source>sform and qform of the T1 lie up to %1 mm apart; the file is in the qform</source>
        <translation>T1 の sform と qform が最大 %1 mm ずれています。ファイルは qform で書かれます</translation>
    </message>
    <message>
        <source>visor2 software version</source>
        <translation>visor2 software version</translation>
    </message>
    <message>
        <source>Coil position x (mm)</source>
        <translation>Coil position x (mm)</translation>
    </message>
    <message>
        <source>Coil position y (mm)</source>
        <translation>Coil position y (mm)</translation>
    </message>
    <message>
        <source>Coil position z (mm)</source>
        <translation>Coil position z (mm)</translation>
    </message>
    <message>
        <source>Stimulation intensity (%)</source>
        <translation>Stimulation intensity (%)</translation>
    </message>
    <message>
        <source>TMS stimulus time (clock time)</source>
        <translation>TMS stimulus time (clock time)</translation>
    </message>
    <message>
        <source>Coil rotation x</source>
        <translation>Coil rotation x</translation>
    </message>
    <message>
        <source>Coil rotation y</source>
        <translation>Coil rotation y</translation>
    </message>
    <message>
        <source>Coil rotation z</source>
        <translation>Coil rotation z</translation>
    </message>
    <message>
        <source>Coil rotation w</source>
        <translation>Coil rotation w</translation>
    </message>
    <message>
        <source>rTMS frequency (hz)</source>
        <translation>rTMS frequency (hz)</translation>
    </message>
    <message>
        <source>visor2 list of pulses</source>
        <translation>visor2 のパルス一覧</translation>
    </message>
    <message>
        <source>is in &apos;%1&apos;, other pulses in &apos;%2&apos;</source>
        <translation>&apos;%1&apos; ですが、ほかのパルスは &apos;%2&apos; です</translation>
    </message>
    <message>
        <source>export one coordinate system</source>
        <translation>1 つの座標系で書き出してください</translation>
    </message>
    <message>
        <source>is damaged XML: %1</source>
        <translation>壊れた XML です: %1</translation>
    </message>
    <message>
        <source>is XML without an element</source>
        <translation>要素のない XML です</translation>
    </message>
    <message>
        <source>the face landmark model cannot be read</source>
        <translation>顔の特徴点モデルを読み込めません</translation>
    </message>
    <message>
        <source>reinstall the package libdlib-data</source>
        <translation>パッケージ libdlib-data を再インストールしてください</translation>
    </message>
    <message>
        <source>only %1 x %2 mm of the face were measured</source>
        <translation>計測できた顔は %1 x %2 mm だけです</translation>
    </message>
    <message>
        <source>show the whole face to both cameras, hair and hands aside, and take the pictures again</source>
        <translation>髪と手をどけて顔全体を両方のカメラに見せ、撮影し直してください</translation>
    </message>
    <message>
        <source>no point of a face was measured</source>
        <translation>顔の点を 1 つも計測できませんでした</translation>
    </message>
    <message>
        <source>turn the face towards both cameras, or choose another frame</source>
        <translation>顔を両方のカメラに向けるか、別のフレームを選んでください</translation>
    </message>
    <message>
        <source>the film has no frame %1</source>
        <translation>映像にフレーム %1 がありません</translation>
    </message>
    <message>
        <source>it has %1 frames, look into timestamps.csv</source>
        <translation>フレームは %1 枚です。timestamps.csv を確認してください</translation>
    </message>
    <message>
        <source>look into timestamps.csv</source>
        <translation>timestamps.csv を確認してください</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>位置合わせ未実施</translation>
    </message>
    <message>
        <source>not aligned: %1</source>
        <translation>位置合わせできません: %1</translation>
    </message>
    <message>
        <source>the face does not fit this MRI: the cameras measure it at %1 of its size there</source>
        <translation>顔がこの MRI と合いません: カメラの計測は MRI の大きさの %1 です</translation>
    </message>
    <message>
        <source>check that this is the patient&apos;s own MRI; if it is, the square size that the cameras were calibrated with</source>
        <translation>患者本人の MRI か確認してください。本人のものなら、カメラの較正に使ったマスの大きさを確認してください</translation>
    </message>
    <message>
        <source>(%1 of it lies on the skin, by %2 mm)</source>
        <translation>(そのうち %1 が皮膚上にあり、ずれは %2 mm)</translation>
    </message>
    <message>
        <source>not aligned: the face does not fit this MRI%1</source>
        <translation>位置合わせできません: 顔がこの MRI と合いません%1</translation>
    </message>
    <message>
        <source>check that this is the patient&apos;s own MRI, and measure the face again</source>
        <translation>患者本人の MRI か確認し、顔を計測し直してください</translation>
    </message>
    <message>
        <source>not aligned: the face fits this MRI only if a camera has turned sideways since the calibration (by %1 +/- %2 deg)</source>
        <translation>位置合わせできません: 較正後にカメラが横に %1 +/- %2 deg 回った場合にだけ、顔がこの MRI と合います</translation>
    </message>
    <message>
        <source>fix the cameras and calibrate them again; if they never moved, check that this is the patient&apos;s own MRI, and its size</source>
        <translation>カメラを固定して較正し直してください。動いていないのなら、患者本人の MRI か、その大きさを確認してください</translation>
    </message>
    <message>
        <source>too little of the face was measured</source>
        <translation>顔の計測範囲が足りません</translation>
    </message>
    <message>
        <source>show the whole face to both cameras, with the dots on it</source>
        <translation>ドットを当てた顔全体を両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>the MRI is mirrored: its left and right are swapped</source>
        <translation>MRI が鏡像です: 左右が入れ替わっています</translation>
    </message>
    <message>
        <source>import the MRI again from its DICOM files</source>
        <translation>MRI を DICOM ファイルから取り込み直してください</translation>
    </message>
    <message>
        <source>the face cannot be distinguished from its mirror image</source>
        <translation>顔とその鏡像を区別できません</translation>
    </message>
    <message>
        <source>bring the cameras nearer, project dots, and show more of the face to both cameras; check that this is the patient&apos;s own MRI, its left and right not swapped</source>
        <translation>カメラを近づけ、ドットを投影し、顔をより広く両方のカメラに向けてください。患者本人の MRI であり、左右が入れ替わっていないことも確かめてください</translation>
    </message>
    <message>
        <source>the pose is ambiguous: the face fits in two places</source>
        <translation>姿勢が定まりません: 顔が 2 か所で合います</translation>
    </message>
    <message>
        <source>show more of the face to both cameras</source>
        <translation>顔のより広い範囲を両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>too little of the face was measured to fix the pose</source>
        <translation>姿勢を定めるには顔の計測範囲が足りません</translation>
    </message>
    <message>
        <source>the cameras measure the face at %1 of the MRI&apos;s size (+/- %2): check the square size that they were calibrated with, and the MRI&apos;s size</source>
        <translation>カメラで計測した顔は MRI の大きさの %1 (+/- %2) です: カメラの較正に使ったマスの大きさと、MRI の大きさを確認してください</translation>
    </message>
    <message>
        <source>the face fixes the pose to %1 mm only: show more of the face to both cameras, and keep it calm</source>
        <translation>顔から定まる姿勢の精度は %1 mm までです: 顔のより広い範囲を両方のカメラに見せ、表情を動かさないでください</translation>
    </message>
    <message>
        <source>the skin fits loosely (by %1 mm): check that this is the patient&apos;s own MRI, and a calm face</source>
        <translation>皮膚の合い方が緩くなっています (%1 mm): 患者本人の MRI であることと、表情が動いていないことを確認してください</translation>
    </message>
    <message>
        <source>%1 of the face is covered (a mask, hair, a hand): the rest was aligned</source>
        <translation>顔の %1 が覆われています (マスク、髪、手): 残りで位置合わせしました</translation>
    </message>
    <message>
        <source>not aligned: too little of the face was measured</source>
        <translation>位置合わせできません: 顔の計測範囲が足りません</translation>
    </message>
    <message>
        <source>a camera may have turned sideways since the calibration (the cameras measure the face at %1 % of the MRI&apos;s size): then head and coil lie up to %2 mm nearer or farther than shown; check the cameras with the board or the coil&apos;s marker (&apos;facenav rig check&apos;)</source>
        <translation>較正後にカメラが横に回った可能性があります (カメラで計測した顔は MRI の大きさの %1 % です): その場合、頭とコイルは表示より最大 %2 mm 近いか遠い位置にあります。ボードまたはコイルのマーカーでカメラを点検してください (&apos;facenav rig check&apos;)</translation>
    </message>
    <message>
        <source>not aligned: the MRI shows no face to align to</source>
        <translation>位置合わせできません: MRI に位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>use a scan with the face in it (not defaced)</source>
        <translation>顔が残っているスキャン (顔を消していないもの) を使ってください</translation>
    </message>
    <message>
        <source>not aligned: too little of the face was measured (%1 points)</source>
        <translation>位置合わせできません: 顔の計測範囲が足りません (%1 点)</translation>
    </message>
    <message>
        <source>%1 covered (hair or an object)</source>
        <translation>%1 が覆われています (髪または物)</translation>
    </message>
    <message>
        <source>%1 %2 mm outside the MRI&apos;s skin</source>
        <translation>%1 が MRI の皮膚より %2 mm 外側</translation>
    </message>
    <message>
        <source>%1 %2 mm inside the MRI&apos;s skin</source>
        <translation>%1 が MRI の皮膚より %2 mm 内側</translation>
    </message>
    <message>
        <source>not aligned: the skin model has no surface</source>
        <translation>位置合わせできません: 皮膚モデルに表面がありません</translation>
    </message>
    <message>
        <source>run &apos;facenav prepare&apos; again</source>
        <translation>&apos;facenav prepare&apos; をもう一度実行してください</translation>
    </message>
    <message>
        <source>FaceNav scalp field 1</source>
        <translation>FaceNav scalp field 1</translation>
    </message>
    <message>
        <source>modelling the skin&apos;s misfit</source>
        <translation>皮膚の不一致をモデル化</translation>
    </message>
    <message>
        <source>checking the fit</source>
        <translation>適合を確認</translation>
    </message>
    <message>
        <source>fitting the face</source>
        <translation>顔を合わせる</translation>
    </message>
    <message>
        <source>searching the head</source>
        <translation>頭部を探索</translation>
    </message>
    <message>
        <source>not aligned: nothing like a face was measured</source>
        <translation>位置合わせできません: 顔らしいものが計測されていません</translation>
    </message>
    <message>
        <source>show the whole face to both cameras</source>
        <translation>顔全体を両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>property float %1</source>
        <translation>property float %1</translation>
    </message>
    <message>
        <source>property uchar %1</source>
        <translation>property uchar %1</translation>
    </message>
    <message>
        <source>there is no %1 image</source>
        <translation>%1 側の画像がありません</translation>
    </message>
    <message>
        <source>record the pair again</source>
        <translation>ペアを撮影し直してください</translation>
    </message>
    <message>
        <source>the %1 image is not 8-bit grey</source>
        <translation>%1 側の画像が 8 ビットのグレーではありません</translation>
    </message>
    <message>
        <source>the %1 image is %2 x %3, but the rig&apos;s images are %4 x %5</source>
        <translation>%1 側の画像は %2 x %3 ですが、カメラ構成の画像は %4 x %5 です</translation>
    </message>
    <message>
        <source>use the stereo.yml of these cameras</source>
        <translation>このカメラの stereo.yml を使ってください</translation>
    </message>
    <message>
        <source>the %1 image is black</source>
        <translation>%1 側の画像が真っ暗です</translation>
    </message>
    <message>
        <source>check lens cap, exposure and cable</source>
        <translation>レンズキャップ、露光、ケーブルを確認してください</translation>
    </message>
    <message>
        <source>the matcher &apos;%1&apos; needs projected dots</source>
        <translation>照合方式 &apos;%1&apos; には投影したドットが必要です</translation>
    </message>
    <message>
        <source>use the matcher &apos;%1&apos; for plain skin</source>
        <translation>ドットのない皮膚には照合方式 &apos;%1&apos; を使ってください</translation>
    </message>
    <message>
        <source>left and right images look swapped</source>
        <translation>左右の画像が入れ替わっているようです</translation>
    </message>
    <message>
        <source>exchange the cameras or the files</source>
        <translation>カメラまたはファイルを入れ替えてください</translation>
    </message>
    <message>
        <source>the images disagree with the calibration by %1 px across the rows</source>
        <translation>画像が較正と行方向に直交して %1 px ずれています</translation>
    </message>
    <message>
        <source>the cameras have moved: calibrate again</source>
        <translation>カメラが動いています: 較正し直してください</translation>
    </message>
    <message>
        <source>no dots found: only %1 points match in both images</source>
        <translation>ドットが見つかりません: 両方の画像で一致した点は %1 個だけです</translation>
    </message>
    <message>
        <source>too little texture: only %1 points match in both images</source>
        <translation>模様が足りません: 両方の画像で一致した点は %1 個だけです</translation>
    </message>
    <message>
        <source>check projector, exposure, depth range and calibration</source>
        <translation>プロジェクター、露光、奥行きの範囲、較正を確認してください</translation>
    </message>
    <message>
        <source>check light, focus, depth range and calibration</source>
        <translation>照明、ピント、奥行きの範囲、較正を確認してください</translation>
    </message>
    <message>
        <source>the spot lies outside the picture</source>
        <translation>点が画像の外にあります</translation>
    </message>
    <message>
        <source>only %1 places are lit by the projector and seen by both cameras</source>
        <translation>プロジェクターが照らし、両方のカメラから見える点は %1 個だけです</translation>
    </message>
    <message>
        <source>let it light what both cameras see, and dim the room</source>
        <translation>両方のカメラから見える範囲を照らし、部屋を暗くしてください</translation>
    </message>
    <message>
        <source>all places lie in one plane: that does not determine the projector</source>
        <translation>すべての点が 1 つの平面上にあります: これではプロジェクターを決定できません</translation>
    </message>
    <message>
        <source>add the plane at another distance, or light something with depth, a face</source>
        <translation>別の距離の平面を加えるか、顔など奥行きのあるものを照らしてください</translation>
    </message>
    <message>
        <source>%1 pictures of the projector&apos;s code are needed, %2 are there</source>
        <translation>プロジェクターのコード画像は %1 枚必要ですが、%2 枚です</translation>
    </message>
    <message>
        <source>take one picture of each, in their order</source>
        <translation>それぞれ 1 枚ずつ、順番どおりに撮影してください</translation>
    </message>
    <message>
        <source>the pictures of the projector&apos;s code have different sizes</source>
        <translation>プロジェクターのコード画像の大きさがそろっていません</translation>
    </message>
    <message>
        <source>take them with one camera</source>
        <translation>1 台のカメラで撮影してください</translation>
    </message>
    <message>
        <source>the projector&apos;s light is not seen: switch it on, and point it at the scene</source>
        <translation>プロジェクターの光が見えません: 電源を入れ、対象に向けてください</translation>
    </message>
    <message>
        <source>the projector is too dim: dim the room, or bring it nearer</source>
        <translation>プロジェクターが暗すぎます: 部屋を暗くするか、近づけてください</translation>
    </message>
    <message>
        <source>the projector is too bright for the cameras: shorten their exposure, or dim it</source>
        <translation>プロジェクターがカメラには明るすぎます: 露光を短くするか、暗くしてください</translation>
    </message>
    <message>
        <source>the projector is out of focus: turn its ring</source>
        <translation>プロジェクターのピントが合っていません: リングを回してください</translation>
    </message>
    <message>
        <source>unknown dense matcher &apos;%1&apos;</source>
        <translation>密な照合方式 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>choose one of: %1</source>
        <translation>次のいずれかを選んでください: %1</translation>
    </message>
    <message>
        <source>one camera stands in front of the other</source>
        <translation>一方のカメラがもう一方の前にあります</translation>
    </message>
    <message>
        <source>depth needs cameras side by side</source>
        <translation>奥行きの計測にはカメラを横に並べる必要があります</translation>
    </message>
    <message>
        <source>the cameras do not look the same way</source>
        <translation>カメラの向きがそろっていません</translation>
    </message>
    <message>
        <source>point both at the head and calibrate again</source>
        <translation>両方を頭に向け、較正し直してください</translation>
    </message>
    <message>
        <source>the region of interest lies outside the image</source>
        <translation>関心領域が画像の外にあります</translation>
    </message>
    <message>
        <source>a ChArUco board is not drawn here</source>
        <translation>ChArUco ボードはここでは描けません</translation>
    </message>
    <message>
        <source>use a chessboard, 9x6 say</source>
        <translation>9x6 などのチェスボードを使ってください</translation>
    </message>
    <message>
        <source>a board of %1 x %2 mm does not fit on A4</source>
        <translation>%1 x %2 mm のボードは A4 に収まりません</translation>
    </message>
    <message>
        <source>choose smaller squares</source>
        <translation>マスを小さくしてください</translation>
    </message>
    <message>
        <source>the picture is too small for the board</source>
        <translation>ボードに対して画像が小さすぎます</translation>
    </message>
    <message>
        <source>use a larger screen</source>
        <translation>より大きな画面を使ってください</translation>
    </message>
    <message>
        <source>%1 are needed</source>
        <translation>%1 必要です</translation>
    </message>
    <message>
        <source>the whole board was found in none of the %1 pairs, %2</source>
        <translation>%1 組のどれにもボード全体が見つかりません。%2</translation>
    </message>
    <message>
        <source>check the board&apos;s size first: it counts inner corners, one less than squares; then light and focus</source>
        <translation>先にボードの大きさを確認してください: 内側の角を数え、マスの数より 1 少なくなります。次に照明とピントを確認してください</translation>
    </message>
    <message>
        <source>the whole board was found in only %1 of %2 pairs, %3</source>
        <translation>ボード全体が見つかったのは %2 組中 %1 組だけです。%3</translation>
    </message>
    <message>
        <source>take more pairs with the whole board in both pictures, sharp and well lit</source>
        <translation>両方の画像にボード全体が鮮明に明るく写る組を増やしてください</translation>
    </message>
    <message>
        <source>the two cameras stand in one place: left and right are pictures of the same camera</source>
        <translation>2 台のカメラが同じ場所にあります: 左右が同じカメラの画像です</translation>
    </message>
    <message>
        <source>give the pictures of two cameras</source>
        <translation>2 台のカメラの画像を使ってください</translation>
    </message>
    <message>
        <source>there are no image pairs to calibrate from</source>
        <translation>較正に使う画像の組がありません</translation>
    </message>
    <message>
        <source>image sizes differ: %1 x %2 beside %3 x %4</source>
        <translation>画像の大きさが異なります: %1 x %2 と %3 x %4</translation>
    </message>
    <message>
        <source>use images of one camera pair at one resolution</source>
        <translation>1 組のカメラの同じ解像度の画像を使ってください</translation>
    </message>
    <message>
        <source>find boards</source>
        <translation>ボードを検出</translation>
    </message>
    <message>
        <source>board not found in the %1 image</source>
        <translation>%1 側の画像にボードが見つかりません</translation>
    </message>
    <message>
        <source>the views do not determine the cameras (%1)</source>
        <translation>この視点ではカメラを決定できません (%1)</translation>
    </message>
    <message>
        <source>take pairs of the board at different angles and distances</source>
        <translation>角度と距離を変えてボードの組を撮影してください</translation>
    </message>
    <message>
        <source>the right camera stands left of the left one: if the lists are swapped, exchange left and right</source>
        <translation>右カメラが左カメラの左にあります: 一覧が入れ替わっているなら、左右を入れ替えてください</translation>
    </message>
    <message>
        <source>the board covers less than half of the %1 image: distortion is a guess elsewhere, add views near the edges</source>
        <translation>ボードが%1 側の画像の半分も覆っていません: ほかの部分の歪みは推測になります。端に近い視点を加えてください</translation>
    </message>
    <message>
        <source>only %1 views were used: 10 or more are better</source>
        <translation>使った視点は %1 個だけです: 10 個以上が望まれます</translation>
    </message>
    <message>
        <source>the board was turned by only %1 deg: add views at more angles</source>
        <translation>ボードの回転は %1 deg だけです: 角度を変えた視点を加えてください</translation>
    </message>
    <message>
        <source>views left out fit twice as badly as those used: add views</source>
        <translation>除いた視点の適合は使った視点の 2 倍悪くなっています: 視点を加えてください</translation>
    </message>
    <message>
        <source>dictionary %1 has fewer markers than the board&apos;s %2</source>
        <translation>辞書 %1 のマーカー数がボードの %2 個に足りません</translation>
    </message>
    <message>
        <source>choose a larger one, 5x5_100 say</source>
        <translation>5x5_100 など、より大きいものを選んでください</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no board size</source>
        <translation>&apos;%1&apos; はボードの大きさではありません</translation>
    </message>
    <message>
        <source>give a chessboard&apos;s inner corners, 9x6 say, or a ChArUco board&apos;s squares, charuco:7x5</source>
        <translation>チェスボードの内側の角の数 (例: 9x6)、または ChArUco ボードのマスの数 (例: charuco:7x5) を指定してください</translation>
    </message>
    <message>
        <source>a square of %1 mm is no size of a board</source>
        <translation>%1 mm のマスはボードの大きさとして正しくありません</translation>
    </message>
    <message>
        <source>measure one and give it in mm, 25 say</source>
        <translation>1 マスを測り、mm で入力してください (例: 25)</translation>
    </message>
    <message>
        <source>the markers must be longer than 0 mm and smaller than the squares</source>
        <translation>マーカーは 0 mm より長く、マスより小さくなければなりません</translation>
    </message>
    <message>
        <source>trigger both cameras together, or hold the board still for each pair</source>
        <translation>両方のカメラを同時にトリガーするか、撮影ごとにボードを静止させてください</translation>
    </message>
    <message>
        <source>the cameras were not triggered together: the board moved between the two exposures in %1 of %2 views, by up to %3 mm</source>
        <translation>カメラが同時にトリガーされていません: %2 視点中 %1 で、2 つの露光の間にボードが最大 %3 mm 動きました</translation>
    </message>
    <message>
        <source>%1, %2 views are left and %3 are needed</source>
        <translation>%1。残りは %2 視点で、%3 視点必要です</translation>
    </message>
    <message>
        <source>%1, and check that both lists name the pairs in one order</source>
        <translation>%1。両方の一覧で組の順番が同じか確認してください</translation>
    </message>
    <message>
        <source>both cameras together fit the views to %1 px, each alone to %2 px: the board may have moved between the two exposures, or a camera between the views. Better %3</source>
        <translation>両カメラを合わせた視点の適合は %1 px、単独では %2 px です: 2 つの露光の間にボードが動いたか、視点の間にカメラが動いた可能性があります。%3</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>corners of the %1 image are off: blur, or a wrong corner</source>
        <translation>%1 側の画像の角がずれています: ぶれ、または角の誤り</translation>
    </message>
    <message>
        <source>disagrees with the other views: the exposures were not simultaneous, the board moved %1 mm between them</source>
        <translation>ほかの視点と合いません: 露光が同時ではなく、その間にボードが %1 mm 動きました</translation>
    </message>
    <message>
        <source>unknown marker dictionary &apos;%1&apos;</source>
        <translation>マーカー辞書 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>the views do not determine the cameras</source>
        <translation>この視点ではカメラを決定できません</translation>
    </message>
    <message>
        <source>it holds image_width, image_height, K, D, R and T (mm) of the projector</source>
        <translation>プロジェクターの image_width、image_height、K、D、R、T (mm) が必要です</translation>
    </message>
    <message>
        <source>key &apos;T&apos; is only %1 long: it looks like metres, millimetres are needed</source>
        <translation>キー &apos;T&apos; の長さが %1 しかありません: メートルのようです。ミリメートルが必要です</translation>
    </message>
    <message>
        <source>is no OpenCV YAML file</source>
        <translation>OpenCV の YAML ファイルではありません</translation>
    </message>
    <message>
        <source>is no valid OpenCV YAML file (%1)</source>
        <translation>正しい OpenCV の YAML ファイルではありません (%1)</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is missing</source>
        <translation>キー &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is no number</source>
        <translation>キー &apos;%1&apos; は数値ではありません</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is no image size in pixels</source>
        <translation>キー &apos;%1&apos; は画像の大きさ (px) ではありません</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is no matrix</source>
        <translation>キー &apos;%1&apos; は行列ではありません</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; holds a value that is not finite</source>
        <translation>キー &apos;%1&apos; に有限でない値があります</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is %2 x %3, %4 was expected</source>
        <translation>キー &apos;%1&apos; は %2 x %3 です。%4 が必要です</translation>
    </message>
    <message>
        <source>key &apos;T&apos; has %1 values, 3 were expected</source>
        <translation>キー &apos;T&apos; の値は %1 個です。3 個が必要です</translation>
    </message>
    <message>
        <source>key &apos;R&apos; is no rotation (orthonormal, determinant +1)</source>
        <translation>キー &apos;R&apos; は回転ではありません (正規直交、行列式 +1)</translation>
    </message>
    <message>
        <source>key &apos;K%1&apos; has no positive focal lengths</source>
        <translation>キー &apos;K%1&apos; の焦点距離が正ではありません</translation>
    </message>
    <message>
        <source>key &apos;K%1&apos; is no camera matrix (fx 0 cx; 0 fy cy; 0 0 1)</source>
        <translation>キー &apos;K%1&apos; はカメラ行列ではありません (fx 0 cx; 0 fy cy; 0 0 1)</translation>
    </message>
    <message>
        <source>key &apos;K%1&apos; has skew, which is not supported</source>
        <translation>キー &apos;K%1&apos; に、対応していないスキューがあります</translation>
    </message>
    <message>
        <source>key &apos;D%1&apos; has %2 coefficients, 4, 5, 8, 12 or 14 were expected</source>
        <translation>キー &apos;D%1&apos; の係数は %2 個です。4、5、8、12、14 個のいずれかが必要です</translation>
    </message>
    <message>
        <source>key &apos;D%1&apos; is no row of coefficients</source>
        <translation>キー &apos;D%1&apos; は係数の行ではありません</translation>
    </message>
    <message>
        <source>key &apos;T&apos; has zero length: both cameras would stand in one place</source>
        <translation>キー &apos;T&apos; の長さが 0 です: 両方のカメラが同じ場所にあることになります</translation>
    </message>
    <message>
        <source>key &apos;%1&apos; is no row time in microseconds: a picture would take %2 ms</source>
        <translation>キー &apos;%1&apos; は行時間 (マイクロ秒) として正しくありません: 1 枚に %2 ms かかることになります</translation>
    </message>
    <message>
        <source>write it with &apos;facenav calibrate&apos; or cv::FileStorage (T in mm), see resources/doc/formats.md</source>
        <translation>&apos;facenav calibrate&apos; または cv::FileStorage (T は mm) で書き出してください。resources/doc/formats.md を参照してください</translation>
    </message>
    <message>
        <source>no %1 image matches</source>
        <translation>%1 に一致する画像がありません</translation>
    </message>
    <message>
        <source>check the path, and quote the pattern</source>
        <translation>パスを確認し、パターンを引用符で囲んでください</translation>
    </message>
    <message>
        <source>there are no %1 images</source>
        <translation>%1 側の画像がありません</translation>
    </message>
    <message>
        <source>left and right counts differ: %1 left images, %2 right ones</source>
        <translation>左右の枚数が異なります: 左 %1 枚、右 %2 枚</translation>
    </message>
    <message>
        <source>each pair needs one image of both sides</source>
        <translation>各組には両側の画像が 1 枚ずつ必要です</translation>
    </message>
    <message>
        <source>left and right numbers differ</source>
        <translation>左右の番号が異なります</translation>
    </message>
    <message>
        <source>give both images of a pair the same number</source>
        <translation>1 組の両方の画像に同じ番号を付けてください</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>シリアル番号 %1</translation>
    </message>
    <message>
        <source>no camera is connected; plug it in</source>
        <translation>カメラが接続されていません。接続してください</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>in use by %1</source>
        <translation>%1 が使用中です</translation>
    </message>
    <message>
        <source>this user may not open it</source>
        <translation>このユーザーには開く権限がありません</translation>
    </message>
    <message>
        <source>it does not answer</source>
        <translation>応答がありません</translation>
    </message>
    <message>
        <source>close that program and look again</source>
        <translation>そのプログラムを閉じて、再検索してください</translation>
    </message>
    <message>
        <source>ask your administrator to add this user to the group &apos;video&apos;, then log in again</source>
        <translation>管理者にこのユーザーを &apos;video&apos; グループへ加えてもらい、ログインし直してください</translation>
    </message>
    <message>
        <source>unplug it, plug it in again and look again</source>
        <translation>いったん外して接続し直し、再検索してください</translation>
    </message>
    <message>
        <source>several cameras are called so</source>
        <translation>同じ名前のカメラが複数あります</translation>
    </message>
    <message>
        <source>give the address of one: %1</source>
        <translation>そのうち 1 台のアドレスを入力してください: %1</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>そのファイルまたはフォルダーはありません</translation>
    </message>
    <message>
        <source>check its name, or type a camera&apos;s address</source>
        <translation>名前を確認するか、カメラのアドレスを入力してください</translation>
    </message>
    <message>
        <source>there is no such camera</source>
        <translation>そのカメラはありません</translation>
    </message>
    <message>
        <source>an equal camera is connected, in another port</source>
        <translation>同型のカメラが別のポートに接続されています</translation>
    </message>
    <message>
        <source>an equal camera is connected, another piece</source>
        <translation>同型の別のカメラが接続されています</translation>
    </message>
    <message>
        <source>plug it into its own port, or make the rig anew</source>
        <translation>元のポートに接続するか、カメラ構成を作り直してください</translation>
    </message>
    <message>
        <source>connect the rig&apos;s own camera, or calibrate and make the rig anew</source>
        <translation>この構成のカメラを接続するか、較正してカメラ構成を作り直してください</translation>
    </message>
    <message>
        <source>the camera is not connected</source>
        <translation>カメラが接続されていません</translation>
    </message>
    <message>
        <source>no camera found: plug two cameras in and look again</source>
        <translation>カメラが見つかりません: カメラを 2 台接続して再検索してください</translation>
    </message>
    <message>
        <source>one camera only: two are needed; plug the other in and look again</source>
        <translation>カメラが 1 台だけです: 2 台必要です。もう 1 台を接続して再検索してください</translation>
    </message>
    <message>
        <source>two equal cameras without serial numbers (%1): only their ports tell them apart; mark cables and ports left and right, keep them so, and open the cameras</source>
        <translation>シリアル番号のない同型のカメラが 2 台あります (%1): ポートでしか区別できません。ケーブルとポートに左右の印を付け、変えずに、カメラを開いてください</translation>
    </message>
    <message>
        <source>the two cameras give no pictures of one moment</source>
        <translation>2 台のカメラの画像の時刻が合いません</translation>
    </message>
    <message>
        <source>set both to the same rate and check their cables</source>
        <translation>両方を同じフレームレートに設定し、ケーブルを確認してください</translation>
    </message>
    <message>
        <source>the camera gives no new picture for %1 s</source>
        <translation>カメラから %1 s 間、新しい画像が来ません</translation>
    </message>
    <message>
        <source>check the cable; then open the cameras again</source>
        <translation>ケーブルを確認し、カメラを開き直してください</translation>
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
        <source>the right picture is taken %1 ms after the left one: the cameras have no common trigger</source>
        <translation>右の画像が左より %1 ms 後に撮影されています: カメラに共通のトリガーがありません</translation>
    </message>
    <message>
        <source>the right picture is taken %1 ms before the left one: the cameras have no common trigger</source>
        <translation>右の画像が左より %1 ms 前に撮影されています: カメラに共通のトリガーがありません</translation>
    </message>
    <message>
        <source>left and right are the same camera</source>
        <translation>左右が同じカメラです</translation>
    </message>
    <message>
        <source>choose two different cameras</source>
        <translation>別々の 2 台のカメラを選んでください</translation>
    </message>
    <message>
        <source>has no frame %1</source>
        <translation>フレーム %1 がありません</translation>
    </message>
    <message>
        <source>this user has no home folder</source>
        <translation>このユーザーにホームフォルダーがありません</translation>
    </message>
    <message>
        <source>this program was built without IEEE 1394 cameras</source>
        <translation>このプログラムは IEEE 1394 カメラに対応せずにビルドされています</translation>
    </message>
    <message>
        <source>install libdc1394-dev and build again</source>
        <translation>libdc1394-dev をインストールして、ビルドし直してください</translation>
    </message>
    <message>
        <source>the camera takes no software trigger</source>
        <translation>カメラがソフトウェアトリガーに対応していません</translation>
    </message>
    <message>
        <source>the camera is in use by another program</source>
        <translation>カメラは別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>close that program</source>
        <translation>そのプログラムを閉じてください</translation>
    </message>
    <message>
        <source>the IEEE 1394 bus cannot carry its pictures</source>
        <translation>IEEE 1394 バスの容量が足りず、画像を送れません</translation>
    </message>
    <message>
        <source>use a lower rate, or a bus for each camera</source>
        <translation>フレームレートを下げるか、カメラごとにバスを分けてください</translation>
    </message>
    <message>
        <source>the camera was unplugged</source>
        <translation>カメラが外されました</translation>
    </message>
    <message>
        <source>plug it in and open the cameras again</source>
        <translation>接続して、カメラを開き直してください</translation>
    </message>
    <message>
        <source>try other settings</source>
        <translation>別の設定を試してください</translation>
    </message>
    <message>
        <source>the camera gives no pictures of %1 x %2 px</source>
        <translation>カメラは %1 x %2 px の画像を出せません</translation>
    </message>
    <message>
        <source>it has none in grey or YUV 4:2:2</source>
        <translation>グレーまたは YUV 4:2:2 の形式がありません</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>出せるのは %1 です</translation>
    </message>
    <message>
        <source>the camera refuses this size</source>
        <translation>カメラがこの画像サイズを受け付けません</translation>
    </message>
    <message>
        <source>the camera gives %1 pictures a second in this size, %2 were asked for</source>
        <translation>カメラはこの画像サイズで毎秒 %1 枚です。指定は %2 枚でした</translation>
    </message>
    <message>
        <source>the camera stays on automatic</source>
        <translation>カメラが自動設定のままです</translation>
    </message>
    <message>
        <source>%1 %2 was asked for, the camera keeps %3</source>
        <translation>%1 は %2 を指定しましたが、カメラは %3 のままです</translation>
    </message>
    <message>
        <source>the camera has no such trigger</source>
        <translation>カメラにそのトリガーはありません</translation>
    </message>
    <message>
        <source>the driver&apos;s time stamps, when the picture came over the bus</source>
        <translation>ドライバーの時刻: 画像がバスを通った時点</translation>
    </message>
    <message>
        <source>the camera refuses to start</source>
        <translation>カメラが開始できません</translation>
    </message>
    <message>
        <source>the camera is not on the IEEE 1394 bus</source>
        <translation>カメラが IEEE 1394 バス上にありません</translation>
    </message>
    <message>
        <source>plug it in; &apos;facenav cameras&apos; lists what is there</source>
        <translation>接続してください。&apos;facenav cameras&apos; で一覧できます</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>ほか %1 件</translation>
    </message>
    <message>
        <source>1 pair is missing</source>
        <translation>1 組が欠けています</translation>
    </message>
    <message>
        <source>%1 pairs are missing</source>
        <translation>%1 組が欠けています</translation>
    </message>
    <message>
        <source>the right file has no partner for left %1</source>
        <translation>左 %1 に対応する右のファイルがありません</translation>
    </message>
    <message>
        <source>the left file has no partner for right %1</source>
        <translation>右 %1 に対応する左のファイルがありません</translation>
    </message>
    <message>
        <source>one file is shorter: if it lacks a picture in between, later pairs are of two moments</source>
        <translation>一方のファイルが短くなっています: 途中の画像が欠けている場合、その後の組は時刻が合いません</translation>
    </message>
    <message>
        <source>this program was built without GenICam cameras</source>
        <translation>このプログラムは GenICam カメラに対応せずにビルドされています</translation>
    </message>
    <message>
        <source>install libaravis-dev and build again</source>
        <translation>libaravis-dev をインストールして、ビルドし直してください</translation>
    </message>
    <message>
        <source>there is no such camera (%1)</source>
        <translation>そのカメラはありません (%1)</translation>
    </message>
    <message>
        <source>check its power and cable; the network card must be in the camera&apos;s network</source>
        <translation>電源とケーブルを確認してください。ネットワークカードはカメラと同じネットワークになければなりません</translation>
    </message>
    <message>
        <source>close that program, here or on another computer, and try again</source>
        <translation>このコンピューターまたは別のコンピューターでそのプログラムを閉じ、再試行してください</translation>
    </message>
    <message>
        <source>check power and cable and open the cameras again</source>
        <translation>電源とケーブルを確認し、カメラを開き直してください</translation>
    </message>
    <message>
        <source>switch the camera off and on and try again</source>
        <translation>カメラの電源を入れ直し、再試行してください</translation>
    </message>
    <message>
        <source>%1; calibrate it with a size that it has</source>
        <translation>%1。出せる画像サイズで較正してください</translation>
    </message>
    <message>
        <source>the camera does not say how large its pictures are</source>
        <translation>カメラから画像の大きさを得られません</translation>
    </message>
    <message>
        <source>its sensor has %1 x %2 px</source>
        <translation>センサーは %1 x %2 px です</translation>
    </message>
    <message>
        <source>it gives %1 x %2 px instead</source>
        <translation>代わりに %1 x %2 px を出します</translation>
    </message>
    <message>
        <source>the camera gives %1 pictures a second, %2 were asked for</source>
        <translation>カメラは毎秒 %1 枚です。指定は %2 枚でした</translation>
    </message>
    <message>
        <source>the camera has no picture format that can be read</source>
        <translation>カメラに読み取れる画像形式がありません</translation>
    </message>
    <message>
        <source>set its format to Mono8</source>
        <translation>形式を Mono8 に設定してください</translation>
    </message>
    <message>
        <source>the camera does not take its picture format</source>
        <translation>カメラがその画像形式を受け付けません</translation>
    </message>
    <message>
        <source>the camera&apos;s time stamps, fitted to this computer&apos;s clock</source>
        <translation>カメラの時刻をこのコンピューターの時計に合わせたもの</translation>
    </message>
    <message>
        <source>the camera gives no stream of pictures</source>
        <translation>カメラから画像のストリームが来ません</translation>
    </message>
    <message>
        <source>the camera does not start</source>
        <translation>カメラが開始しません</translation>
    </message>
    <message>
        <source>the camera has no such control</source>
        <translation>カメラにその設定はありません</translation>
    </message>
    <message>
        <source>%1 is outside the camera&apos;s range, %2 to %3</source>
        <translation>%1 はカメラの範囲 (%2〜%3) の外です</translation>
    </message>
    <message>
        <source>the camera does not read its value back (%1)</source>
        <translation>カメラから値を読み戻せません (%1)</translation>
    </message>
    <message>
        <source>%1 was asked for, the camera keeps %2</source>
        <translation>%1 を指定しましたが、カメラは %2 のままです</translation>
    </message>
    <message>
        <source>white balance</source>
        <translation>ホワイトバランス</translation>
    </message>
    <message>
        <source>GenICam cameras have no colour temperature</source>
        <translation>GenICam カメラには色温度がありません</translation>
    </message>
    <message>
        <source>the lens is focused by hand</source>
        <translation>レンズのピントは手で合わせます</translation>
    </message>
    <message>
        <source>the camera has no software trigger</source>
        <translation>カメラにソフトウェアトリガーがありません</translation>
    </message>
    <message>
        <source>the camera has no trigger input</source>
        <translation>カメラにトリガー入力がありません</translation>
    </message>
    <message>
        <source>let the cameras run free, or use cameras with a trigger</source>
        <translation>トリガーなしで撮影するか、トリガー付きのカメラを使ってください</translation>
    </message>
    <message>
        <source>image file is empty</source>
        <translation>画像ファイルが空です</translation>
    </message>
    <message>
        <source>record it again</source>
        <translation>撮影し直してください</translation>
    </message>
    <message>
        <source>image file is truncated</source>
        <translation>画像ファイルが途中で切れています</translation>
    </message>
    <message>
        <source>copy or record it again</source>
        <translation>もう一度コピーするか、撮影し直してください</translation>
    </message>
    <message>
        <source>this is a film, not a picture</source>
        <translation>これは動画で、画像ではありません</translation>
    </message>
    <message>
        <source>give pictures; a film of the board goes to &apos;facenav rig new&apos; as --left-camera or --right-camera</source>
        <translation>画像を指定してください。ボードの動画は &apos;facenav rig new&apos; の --left-camera または --right-camera に渡します</translation>
    </message>
    <message>
        <source>image cannot be decoded</source>
        <translation>画像を復号できません</translation>
    </message>
    <message>
        <source>save it as PNG, JPEG, BMP or TIFF</source>
        <translation>PNG、JPEG、BMP、TIFF のいずれかで保存してください</translation>
    </message>
    <message>
        <source>image has neither 8 nor 16 bits</source>
        <translation>画像が 8 ビットでも 16 ビットでもありません</translation>
    </message>
    <message>
        <source>save it with 8 bits</source>
        <translation>8 ビットで保存してください</translation>
    </message>
    <message>
        <source>left and right counts differ: %1 images in left/, %2 in right/</source>
        <translation>左右の枚数が異なります: left/ に %1 枚、right/ に %2 枚</translation>
    </message>
    <message>
        <source>each frame needs one image on both sides</source>
        <translation>各フレームには両側の画像が 1 枚ずつ必要です</translation>
    </message>
    <message>
        <source>left and right frame numbers differ: %1 stands beside %2</source>
        <translation>左右のフレーム番号が異なります: %1 と %2 が並んでいます</translation>
    </message>
    <message>
        <source>folder &apos;right&apos; is missing</source>
        <translation>フォルダー &apos;right&apos; がありません</translation>
    </message>
    <message>
        <source>folder &apos;left&apos; is missing</source>
        <translation>フォルダー &apos;left&apos; がありません</translation>
    </message>
    <message>
        <source>a recording has left/ and right/</source>
        <translation>記録には left/ と right/ があります</translation>
    </message>
    <message>
        <source>camera to screen: %1 ms (median), %2 ms (95 %), over %3 changes, %4 missed; %5 ms of it from the screen to the time stamp, %6 ms from there to this program, at %7 pictures a second</source>
        <translation>カメラから画面まで: 中央値 %1 ms、95 % %2 ms (変化 %3 回、見逃し %4 回); うち画面から時刻印まで %5 ms、そこからこのプログラムまで %6 ms (毎秒 %7 枚)</translation>
    </message>
    <message>
        <source>the camera does not see the flashing field</source>
        <translation>カメラに点滅する領域が写っていません</translation>
    </message>
    <message>
        <source>point it at the field, near and sharp, and dim the room</source>
        <translation>カメラを近くから鮮明に領域へ向け、部屋を暗くしてください</translation>
    </message>
    <message>
        <source>image name holds no frame number</source>
        <translation>画像名にフレーム番号がありません</translation>
    </message>
    <message>
        <source>name images 000000.png, 000001.png</source>
        <translation>画像名を 000000.png、000001.png のようにしてください</translation>
    </message>
    <message>
        <source>two images have the number %1 (%2, %3)</source>
        <translation>番号 %1 の画像が 2 枚あります (%2、%3)</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>一方を削除してください</translation>
    </message>
    <message>
        <source>right_t_s is far from t_s</source>
        <translation>right_t_s が t_s から大きく離れています</translation>
    </message>
    <message>
        <source>both are seconds of one clock</source>
        <translation>どちらも同じ時計の秒です</translation>
    </message>
    <message>
        <source>frame is no whole number</source>
        <translation>フレームが整数ではありません</translation>
    </message>
    <message>
        <source>time does not rise</source>
        <translation>時刻が増えていません</translation>
    </message>
    <message>
        <source>t_s must grow from line to line</source>
        <translation>t_s は行ごとに増えなければなりません</translation>
    </message>
    <message>
        <source>frame number does not rise</source>
        <translation>フレーム番号が増えていません</translation>
    </message>
    <message>
        <source>has %1 lines, but the recording %2 frames (frame %3 has no line)</source>
        <translation>%1 行ありますが、記録は %2 フレームです (フレーム %3 の行がありません)</translation>
    </message>
    <message>
        <source>each frame needs its line</source>
        <translation>各フレームに 1 行必要です</translation>
    </message>
    <message>
        <source>image &apos;%1.png&apos; is missing</source>
        <translation>画像 &apos;%1.png&apos; がありません</translation>
    </message>
    <message>
        <source>capture/ needs plain_left and plain_right, and with a projector pattern_left and pattern_right</source>
        <translation>capture/ には plain_left と plain_right が、プロジェクターを使う場合は pattern_left と pattern_right も必要です</translation>
    </message>
    <message>
        <source>the recording&apos;s folder is empty</source>
        <translation>記録のフォルダーが空です</translation>
    </message>
    <message>
        <source>choose another recording</source>
        <translation>別の記録を選んでください</translation>
    </message>
    <message>
        <source>recording does not exist</source>
        <translation>記録がありません</translation>
    </message>
    <message>
        <source>is no folder</source>
        <translation>フォルダーではありません</translation>
    </message>
    <message>
        <source>give the recording&apos;s folder</source>
        <translation>記録のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>image is %1 x %2, but stereo.yml is for %3 x %4</source>
        <translation>画像は %1 x %2 ですが、stereo.yml は %3 x %4 用です</translation>
    </message>
    <message>
        <source>the recording&apos;s folder is missing</source>
        <translation>記録のフォルダーがありません</translation>
    </message>
    <message>
        <source>connect its disk or open another recording</source>
        <translation>そのディスクを接続するか、別の記録を開いてください</translation>
    </message>
    <message>
        <source>has neither left/ and right/ nor left.mkv and right.mkv</source>
        <translation>left/ と right/ も、left.mkv と right.mkv もありません</translation>
    </message>
    <message>
        <source>is it a recording? see resources/doc/formats.md</source>
        <translation>記録ですか? resources/doc/formats.md を参照してください</translation>
    </message>
    <message>
        <source>the recording holds 0 frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>image cannot be written</source>
        <translation>画像を書き込めません</translation>
    </message>
    <message>
        <source>folder cannot be made (%1)</source>
        <translation>フォルダーを作成できません (%1)</translation>
    </message>
    <message>
        <source>is no trigger: free_run, software or hardware</source>
        <translation>トリガーではありません: free_run、software、hardware のいずれかです</translation>
    </message>
    <message>
        <source>must be more than 0</source>
        <translation>0 より大きくなければなりません</translation>
    </message>
    <message>
        <source>is of a newer program</source>
        <translation>より新しいプログラムのものです</translation>
    </message>
    <message>
        <source>row_times: a picture would take longer than 100 ms</source>
        <translation>row_times: 1 枚に 100 ms より長くかかることになります</translation>
    </message>
    <message>
        <source>remove row_times: they are measured anew</source>
        <translation>row_times を削除してください: 測定し直されます</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>あるもの: %1</translation>
    </message>
    <message>
        <source>there is none yet; make one with: facenav rig new</source>
        <translation>まだありません。facenav rig new で作成してください</translation>
    </message>
    <message>
        <source>name a folder for the rigs with --rigs</source>
        <translation>カメラ構成のフォルダーを --rigs で指定してください</translation>
    </message>
    <message>
        <source>this is no name for a rig</source>
        <translation>カメラ構成の名前として使えません</translation>
    </message>
    <message>
        <source>use up to 64 letters, digits, blanks, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>64 文字までの英字、数字、空白、&apos;-&apos;、&apos;_&apos;、&apos;.&apos; を使ってください</translation>
    </message>
    <message>
        <source>there is no such rig</source>
        <translation>そのカメラ構成はありません</translation>
    </message>
    <message>
        <source>the folder for rigs cannot be made (%1)</source>
        <translation>カメラ構成のフォルダーを作成できません (%1)</translation>
    </message>
    <message>
        <source>the rig knows no cameras: it was made from files alone</source>
        <translation>カメラ構成にカメラの情報がありません: ファイルだけから作られています</translation>
    </message>
    <message>
        <source>make it again with --left-camera and --right-camera</source>
        <translation>--left-camera と --right-camera で作り直してください</translation>
    </message>
    <message>
        <source>%1 camera, %2: was %3, is %4 again</source>
        <translation>%1 側カメラ、%2: %3 だったため %4 に戻しました</translation>
    </message>
    <message>
        <source>the folder has no pictures of %1 x %2 px</source>
        <translation>フォルダーに %1 x %2 px の画像がありません</translation>
    </message>
    <message>
        <source>they have %1 x %2; choose this size</source>
        <translation>画像は %1 x %2 です。この大きさを選んでください</translation>
    </message>
    <message>
        <source>the numbers of the pictures, at the wanted rate</source>
        <translation>画像の番号と指定のフレームレートによります</translation>
    </message>
    <message>
        <source>the pictures of the folder are at their end</source>
        <translation>フォルダーの画像が終わりました</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>開き直してください</translation>
    </message>
    <message>
        <source>the pictures of the folder have different sizes</source>
        <translation>フォルダーの画像の大きさがそろっていません</translation>
    </message>
    <message>
        <source>keep the pictures of one camera only</source>
        <translation>1 台のカメラの画像だけにしてください</translation>
    </message>
    <message>
        <source>a folder has no trigger</source>
        <translation>フォルダーにトリガーはありません</translation>
    </message>
    <message>
        <source>let the cameras run free</source>
        <translation>トリガーなしで撮影してください</translation>
    </message>
    <message>
        <source>the folder is a recording of both cameras</source>
        <translation>このフォルダーは両方のカメラの記録です</translation>
    </message>
    <message>
        <source>give its folders left and right as the two cameras</source>
        <translation>その left と right のフォルダーを 2 台のカメラとして指定してください</translation>
    </message>
    <message>
        <source>there is no picture in this folder</source>
        <translation>このフォルダーに画像がありません</translation>
    </message>
    <message>
        <source>give a folder of numbered pictures, or a video</source>
        <translation>番号付き画像のフォルダー、または動画を指定してください</translation>
    </message>
    <message>
        <source>is the file whole, and its codec installed?</source>
        <translation>ファイルは完全で、コーデックがインストールされていますか?</translation>
    </message>
    <message>
        <source>is it switched on? No password is kept for it: type the address once with it, name:password@</source>
        <translation>電源は入っていますか? パスワードが保存されていません: name:password@ を付けてアドレスを一度入力してください</translation>
    </message>
    <message>
        <source>check the address, and that the camera is switched on</source>
        <translation>アドレスと、カメラの電源を確認してください</translation>
    </message>
    <message>
        <source>the stream cannot be opened</source>
        <translation>ストリームを開けません</translation>
    </message>
    <message>
        <source>the stream gives no pictures of %1 x %2 px</source>
        <translation>ストリームは %1 x %2 px の画像を出せません</translation>
    </message>
    <message>
        <source>it has %1 x %2; choose this size</source>
        <translation>画像は %1 x %2 です。この大きさを選んでください</translation>
    </message>
    <message>
        <source>it has %1 x %2; set the sender to the calibrated size</source>
        <translation>画像は %1 x %2 です。送信側を較正時の大きさに設定してください</translation>
    </message>
    <message>
        <source>the file&apos;s time stamps, from its start</source>
        <translation>ファイルの時刻 (先頭から)</translation>
    </message>
    <message>
        <source>the sender&apos;s time stamps, fitted to this computer&apos;s clock</source>
        <translation>送信側の時刻をこのコンピューターの時計に合わせたもの</translation>
    </message>
    <message>
        <source>time of arrival; this kind of stream has no time stamps</source>
        <translation>到着時刻。この種のストリームには時刻がありません</translation>
    </message>
    <message>
        <source>exposure, gain, focus and white balance of a stream are set at its sender</source>
        <translation>ストリームの露光、ゲイン、ピント、ホワイトバランスは送信側で設定します</translation>
    </message>
    <message>
        <source>the video is at its end</source>
        <translation>動画が終わりました</translation>
    </message>
    <message>
        <source>the stream broke off</source>
        <translation>ストリームが途切れました</translation>
    </message>
    <message>
        <source>check the network and the camera, then open the cameras again</source>
        <translation>ネットワークとカメラを確認し、カメラを開き直してください</translation>
    </message>
    <message>
        <source>the pictures of the stream come too late</source>
        <translation>ストリームの画像の到着が遅すぎます</translation>
    </message>
    <message>
        <source>let the sender send fewer or smaller pictures, or close other programs</source>
        <translation>送信側で枚数か画像サイズを減らすか、ほかのプログラムを閉じてください</translation>
    </message>
    <message>
        <source>a stream has no trigger</source>
        <translation>ストリームにトリガーはありません</translation>
    </message>
    <message>
        <source>this is one picture, not a film</source>
        <translation>これは 1 枚の画像で、動画ではありません</translation>
    </message>
    <message>
        <source>give a video, or the folder of the pictures</source>
        <translation>動画、または画像のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>set HOME: passwords of cameras are kept there</source>
        <translation>HOME を設定してください: カメラのパスワードの保存先です</translation>
    </message>
    <message>
        <source>quaternion is not of unit length</source>
        <translation>四元数の長さが 1 ではありません</translation>
    </message>
    <message>
        <source>time of arrival; the driver gives no time stamps</source>
        <translation>到着時刻。ドライバーに時刻がありません</translation>
    </message>
    <message>
        <source>the driver&apos;s time stamps, fitted to this computer&apos;s clock</source>
        <translation>ドライバーの時刻をこのコンピューターの時計に合わせたもの</translation>
    </message>
    <message>
        <source>the driver&apos;s time stamps, at the start of exposure</source>
        <translation>ドライバーの時刻 (露光の開始時)</translation>
    </message>
    <message>
        <source>the driver&apos;s time stamps, at the end of the picture</source>
        <translation>ドライバーの時刻 (画像の終わり)</translation>
    </message>
    <message>
        <source>Video4Linux has no trigger</source>
        <translation>Video4Linux にトリガーはありません</translation>
    </message>
    <message>
        <source>compressed pictures (MJPG): the USB connection cannot carry others</source>
        <translation>圧縮画像 (MJPG): USB 接続ではほかの形式を送れません</translation>
    </message>
    <message>
        <source>the camera does not read its value back</source>
        <translation>カメラから値を読み戻せません</translation>
    </message>
    <message>
        <source>the camera has no such control; it may adjust itself unseen</source>
        <translation>カメラにその設定はありません。気付かないうちに自動調整される可能性があります</translation>
    </message>
    <message>
        <source>close that program and try again</source>
        <translation>そのプログラムを閉じて、再試行してください</translation>
    </message>
    <message>
        <source>this user may not open the camera</source>
        <translation>このユーザーにはカメラを開く権限がありません</translation>
    </message>
    <message>
        <source>check the cable and open the cameras again</source>
        <translation>ケーブルを確認し、カメラを開き直してください</translation>
    </message>
    <message>
        <source>plug it in and look again</source>
        <translation>接続して、再検索してください</translation>
    </message>
    <message>
        <source>the USB connection cannot carry this camera&apos;s pictures as well</source>
        <translation>USB 接続の容量が足りず、このカメラの画像を同時に送れません</translation>
    </message>
    <message>
        <source>plug the two cameras into different USB controllers, or choose the format MJPG</source>
        <translation>2 台のカメラを別々の USB コントローラーに接続するか、形式 MJPG を選んでください</translation>
    </message>
    <message>
        <source>unplug the camera, plug it in again and try again</source>
        <translation>カメラを外して接続し直し、再試行してください</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>カメラを開けません</translation>
    </message>
    <message>
        <source>this is no Video4Linux camera</source>
        <translation>Video4Linux のカメラではありません</translation>
    </message>
    <message>
        <source>this device takes no pictures</source>
        <translation>この装置は画像を撮影できません</translation>
    </message>
    <message>
        <source>choose another camera</source>
        <translation>別のカメラを選んでください</translation>
    </message>
    <message>
        <source>the camera gives no pictures of %1 x %2 px in the format %3</source>
        <translation>カメラは形式 %3 で %1 x %2 px の画像を出せません</translation>
    </message>
    <message>
        <source>it has %1; calibrate it with one of these sizes</source>
        <translation>出せるのは %1 です。そのいずれかの大きさで較正してください</translation>
    </message>
    <message>
        <source>it gives %1 x %2 px instead; calibrate it with that size</source>
        <translation>代わりに %1 x %2 px を出します。その大きさで較正してください</translation>
    </message>
    <message>
        <source>the camera&apos;s driver gives no memory for its pictures</source>
        <translation>カメラのドライバーが画像用のメモリーを確保できません</translation>
    </message>
    <message>
        <source>the camera&apos;s pictures cannot be mapped into memory</source>
        <translation>カメラの画像をメモリーに割り当てられません</translation>
    </message>
    <message>
        <source>the camera&apos;s driver takes no memory for its pictures</source>
        <translation>カメラのドライバーが画像用のメモリーを受け付けません</translation>
    </message>
    <message>
        <source>the camera&apos;s pictures cannot be waited for</source>
        <translation>カメラの画像を待てません</translation>
    </message>
    <message>
        <source>the camera gives no picture</source>
        <translation>カメラから画像が来ません</translation>
    </message>
    <message>
        <source>video cannot be opened</source>
        <translation>動画を開けません</translation>
    </message>
    <message>
        <source>is it whole, and its codec installed?</source>
        <translation>ファイルは完全で、コーデックがインストールされていますか?</translation>
    </message>
    <message>
        <source>left and right counts differ: %1 frames in %2, %3 in %4</source>
        <translation>左右のフレーム数が異なります: %2 に %1、%4 に %3</translation>
    </message>
    <message>
        <source>both videos must hold the same frames</source>
        <translation>両方の動画のフレームが同じでなければなりません</translation>
    </message>
    <message>
        <source>video ends or is damaged at frame %1 of %2</source>
        <translation>動画が %2 フレーム中 %1 で終わっているか、壊れています</translation>
    </message>
    <message>
        <source>the right video is missing</source>
        <translation>右の動画がありません</translation>
    </message>
    <message>
        <source>the left video is missing</source>
        <translation>左の動画がありません</translation>
    </message>
    <message>
        <source>a recording has left.mkv and right.mkv</source>
        <translation>記録には left.mkv と right.mkv があります</translation>
    </message>
    <message>
        <source>the two cameras&apos; pictures are of different moments</source>
        <translation>2 台のカメラの画像の時刻が合いません</translation>
    </message>
    <message>
        <source>trigger both cameras together, or check cables and driver</source>
        <translation>両方のカメラを同時にトリガーするか、ケーブルとドライバーを確認してください</translation>
    </message>
    <message>
        <source>left and right are exchanged</source>
        <translation>左右が入れ替わっています</translation>
    </message>
    <message>
        <source>exchange the cameras or the folders</source>
        <translation>カメラまたはフォルダーを入れ替えてください</translation>
    </message>
    <message>
        <source>the cameras have moved since their calibration</source>
        <translation>較正後にカメラが動いています</translation>
    </message>
    <message>
        <source>calibrate again; if that does not help, trigger both cameras together</source>
        <translation>較正し直してください。直らない場合は、両方のカメラを同時にトリガーしてください</translation>
    </message>
    <message>
        <source>the calibration does not belong to these cameras</source>
        <translation>較正がこのカメラのものではありません</translation>
    </message>
    <message>
        <source>give the right stereo.yml, or calibrate</source>
        <translation>正しい stereo.yml を指定するか、較正してください</translation>
    </message>
    <message>
        <source>the cameras have moved since their calibration (%1 px across the epipolar lines, points off by %2 mm)</source>
        <translation>較正後にカメラが動いています (エピポーラ線に直交して %1 px、点のずれ %2 mm)</translation>
    </message>
    <message>
        <source>calibrate again</source>
        <translation>較正し直してください</translation>
    </message>
    <message>
        <source>the coil&apos;s marker is not measured at its printed size: a camera has turned since the calibration, or coil.json names another size</source>
        <translation>コイルのマーカーが印刷時の大きさで計測されません: 較正後にカメラが回ったか、coil.json の大きさが異なります</translation>
    </message>
    <message>
        <source>measure the print, or calibrate again</source>
        <translation>印刷物を測るか、較正し直してください</translation>
    </message>
    <message>
        <source>a camera has moved on its mount since the alignment (%1 deg)</source>
        <translation>位置合わせ後にカメラが台座の上で動きました (%1 deg)</translation>
    </message>
    <message>
        <source>fix the cameras, then calibrate and align again</source>
        <translation>カメラを固定してから、較正と位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>a camera has moved on its mount since the alignment (%1 deg): corrected by the face, fix the cameras and calibrate again when the patient has left</source>
        <translation>位置合わせ後にカメラが台座の上で動きました (%1 deg): 顔によって補正しています。患者の退室後、カメラを固定して較正し直してください</translation>
    </message>
    <message>
        <source>%1: cannot be measured with this calibration, %2 mm true</source>
        <translation>%1: この較正では計測できません。正しくは %2 mm です</translation>
    </message>
    <message>
        <source>%1: %2 mm measured, %3 mm true: %4 mm, %5 % (+-%6 mm if the calibration holds)</source>
        <translation>%1: 計測 %2 mm、正しくは %3 mm: %4 mm、%5 % (較正が正しければ +-%6 mm)</translation>
    </message>
    <message>
        <source>the rows fit, but the length does not, and by the same %1 % at every distance: the squares measure %2 mm, not %3 mm; measure one and give its size again</source>
        <translation>行は合いますが長さが合わず、どの距離でも同じ %1 % ずれています: マスは %3 mm ではなく %2 mm です。1 マスを測り、大きさを入力し直してください</translation>
    </message>
    <message>
        <source>the rows fit, but the length does not: check the size of a square first (%1 mm is given, %2 mm would fit); if it is right, a camera has turned sideways: calibrate again</source>
        <translation>行は合いますが長さが合いません: まずマスの大きさを確認してください (指定は %1 mm、合うのは %2 mm)。正しければ、カメラが横に回っています: 較正し直してください</translation>
    </message>
    <message>
        <source>it moved %1 mm and turned %2 deg between the measurements</source>
        <translation>計測の間に %1 mm 動き、%2 deg 回りました</translation>
    </message>
    <message>
        <source>it moved only %1 mm between the measurements: move it by %2 mm and measure again</source>
        <translation>計測の間の移動が %1 mm だけです: %2 mm 動かして計測し直してください</translation>
    </message>
    <message>
        <source>%1 frames; board in %2, marker in %3</source>
        <translation>%1 フレーム。ボードあり %2、マーカーあり %3</translation>
    </message>
    <message>
        <source>distance of a point from its row in the other picture: %1 px</source>
        <translation>もう一方の画像での点と行の距離: %1 px</translation>
    </message>
    <message>
        <source>each camera&apos;s own picture of the board: left %1 px, right %2 px</source>
        <translation>各カメラ単独のボード画像: 左 %1 px、右 %2 px</translation>
    </message>
    <message>
        <source>the calibration holds</source>
        <translation>較正は正しく保たれています</translation>
    </message>
    <message>
        <source>the %1 measures %2 mm, %3 mm true (%4 mm, %5 %)</source>
        <translation>%1 の計測値は %2 mm、正しくは %3 mm (%4 mm、%5 %)</translation>
    </message>
    <message>
        <source>another camera, or its focus or zoom was changed; calibrate again</source>
        <translation>別のカメラか、ピントまたはズームが変わっています。較正し直してください</translation>
    </message>
    <message>
        <source>one picture is larger by %1 % than the calibration says: %2</source>
        <translation>一方の画像が較正より %1 % 大きくなっています: %2</translation>
    </message>
    <message>
        <source>the left camera&apos;s pictures do not fit its lens (%1 px): %2</source>
        <translation>左カメラの画像がレンズと合いません (%1 px): %2</translation>
    </message>
    <message>
        <source>the right camera&apos;s pictures do not fit its lens (%1 px): %2</source>
        <translation>右カメラの画像がレンズと合いません (%1 px): %2</translation>
    </message>
    <message>
        <source>left and right are exchanged: swap the two cameras</source>
        <translation>左右が入れ替わっています: 2 台のカメラを入れ替えてください</translation>
    </message>
    <message>
        <source>neither board nor marker was seen well enough: hold one still before both cameras and check again</source>
        <translation>ボードもマーカーも十分に見えませんでした: どちらかを両方のカメラの前で静止させ、もう一度点検してください</translation>
    </message>
    <message>
        <source>the cameras have moved against each other since their calibration</source>
        <translation>較正後にカメラ同士の位置がずれています</translation>
    </message>
    <message>
        <source>the right one turned by about %1 deg</source>
        <translation>右カメラが約 %1 deg 回っています</translation>
    </message>
    <message>
        <source>moved by about %1 mm</source>
        <translation>約 %1 mm 動いています</translation>
    </message>
    <message>
        <source>%1 measured %2 mm instead of %3 mm</source>
        <translation>%1 の計測値が %3 mm ではなく %2 mm です</translation>
    </message>
    <message>
        <source>rows %1 px apart</source>
        <translation>行のずれ %1 px</translation>
    </message>
    <message>
        <source>%1, or the coil&apos;s marker has another size than its file says: measure the print, or calibrate again</source>
        <translation>%1、またはコイルのマーカーの大きさがファイルと異なります: 印刷物を測るか、較正し直してください</translation>
    </message>
    <message>
        <source>%1: calibrate again</source>
        <translation>%1: 較正し直してください</translation>
    </message>
    <message>
        <source>the pictures are %1 x %2 px, the rig&apos;s %3 x %4</source>
        <translation>画像は %1 x %2 px ですが、カメラ構成は %3 x %4 です</translation>
    </message>
    <message>
        <source>use pictures of the rig&apos;s own cameras in their calibrated size</source>
        <translation>このカメラ構成のカメラで、較正時の大きさの画像を使ってください</translation>
    </message>
    <message>
        <source>not an atlas registration: %1</source>
        <translation>アトラスの位置合わせではありません: %1</translation>
    </message>
    <message>
        <source>no 4 x 4 field mri_from_mni</source>
        <translation>4 x 4 の項目 mri_from_mni がありません</translation>
    </message>
    <message>
        <source>mri_from_mni is mirrored or no affine</source>
        <translation>mri_from_mni が鏡映か、アフィンではありません</translation>
    </message>
    <message>
        <source>the atlas registration could not be encoded</source>
        <translation>アトラスの位置合わせを符号化できませんでした</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>そのファイルはありません</translation>
    </message>
    <message>
        <source>no .vti file</source>
        <translation>.vti ファイルがありません</translation>
    </message>
    <message>
        <source>no displacement</source>
        <translation>変位がありません</translation>
    </message>
    <message>
        <source>the brain is empty, nothing to register the atlas to</source>
        <translation>脳が空で、アトラスを合わせる対象がありません</translation>
    </message>
    <message>
        <source>the atlas is not installed</source>
        <translation>アトラスがインストールされていません</translation>
    </message>
    <message>
        <source>install Debian&apos;s mricron-data</source>
        <translation>Debian の mricron-data をインストールしてください</translation>
    </message>
    <message>
        <source>the atlas&apos; names are not installed</source>
        <translation>アトラスの名称がインストールされていません</translation>
    </message>
    <message>
        <source>temporal pole</source>
        <translation>側頭極</translation>
    </message>
    <message>
        <source>underside of the temporal lobe</source>
        <translation>側頭葉の下面</translation>
    </message>
    <message>
        <source>temporal lobe</source>
        <translation>側頭葉</translation>
    </message>
    <message>
        <source>underside of the frontal lobe</source>
        <translation>前頭葉の下面</translation>
    </message>
    <message>
        <source>motor strip</source>
        <translation>運動野の帯</translation>
    </message>
    <message>
        <source>sensory strip</source>
        <translation>感覚野の帯</translation>
    </message>
    <message>
        <source>frontal lobe</source>
        <translation>前頭葉</translation>
    </message>
    <message>
        <source>parietal lobe</source>
        <translation>頭頂葉</translation>
    </message>
    <message>
        <source>occipital lobe</source>
        <translation>後頭葉</translation>
    </message>
    <message>
        <source>brainstem and base</source>
        <translation>脳幹と脳底</translation>
    </message>
    <message>
        <source>registering the atlas</source>
        <translation>アトラスの位置合わせ</translation>
    </message>
    <message>
        <source>deflated data set is damaged</source>
        <translation>圧縮されたデータセットが壊れています</translation>
    </message>
    <message>
        <source>DICOM header is cut off or damaged</source>
        <translation>DICOM ヘッダーが切れているか、壊れています</translation>
    </message>
    <message>
        <source>DICOM header is damaged (an element of unknown type)</source>
        <translation>DICOM ヘッダーが壊れています (不明な型の要素)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (sequences nested without end)</source>
        <translation>DICOM ヘッダーが壊れています (際限のない入れ子)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (a value without length)</source>
        <translation>DICOM ヘッダーが壊れています (長さのない値)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (a sequence of wrong length)</source>
        <translation>DICOM ヘッダーが壊れています (長さの誤ったシーケンス)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (no item where a sequence holds one)</source>
        <translation>DICOM ヘッダーが壊れています (シーケンスに項目がありません)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (a stray sequence delimiter)</source>
        <translation>DICOM ヘッダーが壊れています (余分なシーケンス区切り)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (an item of wrong length)</source>
        <translation>DICOM ヘッダーが壊れています (長さの誤った項目)</translation>
    </message>
    <message>
        <source>DICOM header is damaged (an element of the pixel group is unknown)</source>
        <translation>DICOM ヘッダーが壊れています (画素グループに不明な要素)</translation>
    </message>
    <message>
        <source>pixel data is cut off</source>
        <translation>画素データが途中で切れています</translation>
    </message>
    <message>
        <source>compressed pixel data is damaged</source>
        <translation>圧縮された画素データが壊れています</translation>
    </message>
    <message>
        <source>check that it exists and its permissions</source>
        <translation>存在することとアクセス権を確認してください</translation>
    </message>
    <message>
        <source>the series holds values that are no numbers</source>
        <translation>シリーズに数値でない値があります</translation>
    </message>
    <message>
        <source>values scaled to 0..4095</source>
        <translation>値を 0..4095 に変換しました</translation>
    </message>
    <message>
        <source>is a %1 series; only an MR series can be written</source>
        <translation>%1 のシリーズです。書き出せるのは MR のシリーズだけです</translation>
    </message>
    <message>
        <source>writing DICOM images</source>
        <translation>DICOM 画像を書き出しています</translation>
    </message>
    <message>
        <source>the document is no PDF</source>
        <translation>文書が PDF ではありません</translation>
    </message>
    <message>
        <source>is no DICOM file any more</source>
        <translation>もう DICOM ファイルではありません</translation>
    </message>
    <message>
        <source>read the folder again</source>
        <translation>フォルダーを読み込み直してください</translation>
    </message>
    <message>
        <source>Procedure Note</source>
        <translation>Procedure Note</translation>
    </message>
    <message>
        <source>&apos;%1&apos; lies outside the images</source>
        <translation>&apos;%1&apos; が画像の外にあります</translation>
    </message>
    <message>
        <source>Physical object</source>
        <translation>Physical object</translation>
    </message>
    <message>
        <source>Spatial and Relational Concept</source>
        <translation>Spatial and Relational Concept</translation>
    </message>
    <message>
        <source>Selected region</source>
        <translation>Selected region</translation>
    </message>
    <message>
        <source>give the series as the archive sent it</source>
        <translation>アーカイブから送られたままのシリーズを指定してください</translation>
    </message>
    <message>
        <source>names no patient, so that an archive could not file what is made from it</source>
        <translation>患者名がなく、そこから作ったものをアーカイブに登録できません</translation>
    </message>
    <message>
        <source>the images of the series name several patients</source>
        <translation>シリーズの画像に複数の患者名があります</translation>
    </message>
    <message>
        <source>names no study (0020,000D)</source>
        <translation>検査 (0020,000D) の記載がありません</translation>
    </message>
    <message>
        <source>Source image for image processing operation</source>
        <translation>Source image for image processing operation</translation>
    </message>
    <message>
        <source>magnitude image</source>
        <translation>強度画像</translation>
    </message>
    <message>
        <source>one inversion of an MP2RAGE</source>
        <translation>MP2RAGE の反転画像の 1 つ</translation>
    </message>
    <message>
        <source>phase image</source>
        <translation>位相画像</translation>
    </message>
    <message>
        <source>real part</source>
        <translation>実部</translation>
    </message>
    <message>
        <source>imaginary part</source>
        <translation>虚部</translation>
    </message>
    <message>
        <source>phase, real part or MP2RAGE UNI by its values</source>
        <translation>値から見て位相、実部、または MP2RAGE UNI</translation>
    </message>
    <message>
        <source>relaxation rate map (R1, R2)</source>
        <translation>緩和率マップ (R1、R2)</translation>
    </message>
    <message>
        <source>proton density map</source>
        <translation>プロトン密度マップ</translation>
    </message>
    <message>
        <source>field map (B0, B1)</source>
        <translation>磁場マップ (B0、B1)</translation>
    </message>
    <message>
        <source>parameter map</source>
        <translation>パラメーターマップ</translation>
    </message>
    <message>
        <source>annotated image (marks are drawn into its voxels)</source>
        <translation>注釈入りの画像 (印がボクセルに描き込まれています)</translation>
    </message>
    <message>
        <source>no patient named</source>
        <translation>患者名なし</translation>
    </message>
    <message>
        <source>DICOM header is damaged</source>
        <translation>DICOM ヘッダーが壊れています</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers, it has commas for decimal points: &apos;%3&apos;</source>
        <translation>%1 が %2 個の数値ではなく、小数点にコンマが使われています: &apos;%3&apos;</translation>
    </message>
    <message>
        <source>%1 is not %2 numbers: &apos;%3&apos;</source>
        <translation>%1 が %2 個の数値ではありません: &apos;%3&apos;</translation>
    </message>
    <message>
        <source>Image Position (Patient)</source>
        <translation>Image Position (Patient)</translation>
    </message>
    <message>
        <source>Image Orientation (Patient)</source>
        <translation>Image Orientation (Patient)</translation>
    </message>
    <message>
        <source>Pixel Spacing</source>
        <translation>Pixel Spacing</translation>
    </message>
    <message>
        <source>more than was asked for</source>
        <translation>要求より多いデータがあります</translation>
    </message>
    <message>
        <source>holds no image</source>
        <translation>画像がありません</translation>
    </message>
    <message>
        <source>image without rows or columns</source>
        <translation>行も列もない画像</translation>
    </message>
    <message>
        <source>image of an impossible size (%1 x %2 x %3)</source>
        <translation>あり得ない大きさの画像 (%1 x %2 x %3)</translation>
    </message>
    <message>
        <source>colour image</source>
        <translation>カラー画像</translation>
    </message>
    <message>
        <source>colour image (palette)</source>
        <translation>カラー画像 (パレット)</translation>
    </message>
    <message>
        <source>%1 bits a voxel are not read</source>
        <translation>1 ボクセル %1 ビットは読み込めません</translation>
    </message>
    <message>
        <source>bits stored, high bit and bits allocated contradict each other</source>
        <translation>bits stored、high bit、bits allocated が矛盾しています</translation>
    </message>
    <message>
        <source>compression %1 is not read</source>
        <translation>圧縮 %1 は読み込めません</translation>
    </message>
    <message>
        <source>transfer syntax and pixel data contradict each other</source>
        <translation>転送構文と画素データが矛盾しています</translation>
    </message>
    <message>
        <source>choose another series</source>
        <translation>別のシリーズを選んでください</translation>
    </message>
    <message>
        <source>compressed pixel data holds no image</source>
        <translation>圧縮された画素データに画像がありません</translation>
    </message>
    <message>
        <source>pixel data holds %1 bytes, %2 were expected</source>
        <translation>画素データは %1 バイトです。%2 バイトが必要です</translation>
    </message>
    <message>
        <source>compressed frames cannot be separated (no offset table)</source>
        <translation>圧縮フレームを分けられません (オフセット表がありません)</translation>
    </message>
    <message>
        <source>compressed frames cannot be separated</source>
        <translation>圧縮フレームを分けられません</translation>
    </message>
    <message>
        <source>compressed pixel data is damaged or of another size than its header says</source>
        <translation>圧縮された画素データが壊れているか、大きさがヘッダーと異なります</translation>
    </message>
    <message>
        <source>does not hold the frame asked for</source>
        <translation>指定のフレームがありません</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm</source>
        <translation>%1 x %2 x %3 ボクセル、%4 x %5 x %6 mm</translation>
    </message>
    <message>
        <source>left and right rest on the file&apos;s %1</source>
        <translation>左右はファイルの %1 によります</translation>
    </message>
    <message>
        <source>the file says that the scan was fitted to a template: its size and shape are then the template&apos;s, not the patient&apos;s; use the scan as acquired</source>
        <translation>スキャンがテンプレートに合わせて変形されていると記載されています: 大きさと形が患者のものではなくテンプレートのものになっています。撮像したままのスキャンを使ってください</translation>
    </message>
    <message>
        <source>choose another series or export it again (&apos;facenav series&apos; lists them)</source>
        <translation>別のシリーズを選ぶか、書き出し直してください (&apos;facenav series&apos; で一覧できます)</translation>
    </message>
    <message>
        <source>this series</source>
        <translation>このシリーズ</translation>
    </message>
    <message>
        <source>%1 is %2, in which no skin can be found</source>
        <translation>%1 は %2 で、皮膚を検出できません</translation>
    </message>
    <message>
        <source>choose the magnitude images of a T1 (&apos;facenav series&apos; lists them)</source>
        <translation>T1 の強度画像を選んでください (&apos;facenav series&apos; で一覧できます)</translation>
    </message>
    <message>
        <source>series &apos;%1&apos; is %2</source>
        <translation>シリーズ &apos;%1&apos; は %2 です</translation>
    </message>
    <message>
        <source>use the series that it was made from, or name it with --series</source>
        <translation>その元になったシリーズを使うか、--series で指定してください</translation>
    </message>
    <message>
        <source>holds no series &apos;%1&apos;</source>
        <translation>シリーズ &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>&apos;facenav series&apos; lists them</source>
        <translation>&apos;facenav series&apos; で一覧できます</translation>
    </message>
    <message>
        <source>holds images of %1 patients</source>
        <translation>患者 %1 人の画像を含んでいます</translation>
    </message>
    <message>
        <source>choose one with --series (&apos;facenav series --patients&apos; shows the patients)</source>
        <translation>--series で 1 つ選んでください (&apos;facenav series --patients&apos; で患者を表示できます)</translation>
    </message>
    <message>
        <source>holds slices with series UIDs of their own that can be read in %1 way (%2)</source>
        <translation>シリーズ UID が別々の断面で、%1 通りに読めます (%2)</translation>
    </message>
    <message>
        <source>holds slices with series UIDs of their own that can be read in %1 ways (%2)</source>
        <translation>シリーズ UID が別々の断面で、%1 通りに読めます (%2)</translation>
    </message>
    <message>
        <source>choose one with --series (&apos;facenav series&apos; lists them)</source>
        <translation>--series で 1 つ選んでください (&apos;facenav series&apos; で一覧できます)</translation>
    </message>
    <message>
        <source>holds %1 series, none of them a 3-D T1 of a head%2</source>
        <translation>シリーズは %1 個ですが、頭部の 3-D T1 がありません%2</translation>
    </message>
    <message>
        <source>without description</source>
        <translation>説明なし</translation>
    </message>
    <message>
        <source>chosen from %1 series, the best T1 for navigation</source>
        <translation>%1 個のシリーズから、ナビゲーションに最適な T1 を選びました</translation>
    </message>
    <message>
        <source>chosen from %1 series</source>
        <translation>%1 個のシリーズから選びました</translation>
    </message>
    <message>
        <source>left and right rest on Image Position and Orientation (Patient), as the scanner wrote them</source>
        <translation>左右は、装置が記録した Image Position と Orientation (Patient) によります</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>series number</source>
        <translation>シリーズ番号</translation>
    </message>
    <message>
        <source>series time</source>
        <translation>シリーズの時刻</translation>
    </message>
    <message>
        <source>slices with %1 different series UIDs were joined</source>
        <translation>シリーズ UID の異なる断面を %1 種類つなぎました</translation>
    </message>
    <message>
        <source>geometry and timing</source>
        <translation>形状と時刻</translation>
    </message>
    <message>
        <source>geometry, timing</source>
        <translation>形状、時刻</translation>
    </message>
    <message>
        <source>no %1 is given</source>
        <translation>%1 が示されていません</translation>
    </message>
    <message>
        <source>one of %1 ways to read them: choose the right one</source>
        <translation>%1 通りの読み方の 1 つ: 正しいものを選んでください</translation>
    </message>
    <message>
        <source>%1. They share one frame-of-reference UID</source>
        <translation>%1. frame-of-reference UID は共通です</translation>
    </message>
    <message>
        <source>%1. No UID says that they share a frame of reference: look for steps between slices</source>
        <translation>%1. 基準座標系が共通であることを示す UID がありません: 断面間の段差を確認してください</translation>
    </message>
    <message>
        <source>a file beside it is damaged: %1</source>
        <translation>同じ場所のファイルが壊れています: %1</translation>
    </message>
    <message>
        <source>holds no files</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>check the path and its permissions</source>
        <translation>パスとアクセス権を確認してください</translation>
    </message>
    <message>
        <source>reading DICOM headers</source>
        <translation>DICOM ヘッダーを読み込んでいます</translation>
    </message>
    <message>
        <source>copy it again</source>
        <translation>もう一度コピーしてください</translation>
    </message>
    <message>
        <source>reading DICOM images</source>
        <translation>DICOM 画像を読み込んでいます</translation>
    </message>
    <message>
        <source>another image lies at the same place</source>
        <translation>同じ場所に別の画像があります</translation>
    </message>
    <message>
        <source>separate the series</source>
        <translation>シリーズを分けてください</translation>
    </message>
    <message>
        <source>the series is too large to read</source>
        <translation>シリーズが大きすぎて読み込めません</translation>
    </message>
    <message>
        <source>bright and dark are exchanged in some of its images (MONOCHROME1)</source>
        <translation>一部の画像で明暗が逆です (MONOCHROME1)</translation>
    </message>
    <message>
        <source>file beside it is</source>
        <translation>同じ場所のファイル</translation>
    </message>
    <message>
        <source>files beside it are</source>
        <translation>同じ場所のファイル</translation>
    </message>
    <message>
        <source>%1 not there (%2)</source>
        <translation>%1 がありません (%2)</translation>
    </message>
    <message>
        <source>file that the DICOMDIR lists is</source>
        <translation>DICOMDIR に記載のファイル</translation>
    </message>
    <message>
        <source>files that the DICOMDIR lists are</source>
        <translation>DICOMDIR に記載のファイル</translation>
    </message>
    <message>
        <source>%1: look whether the head is whole, or copy the scan again</source>
        <translation>%1: 頭部全体があるか確認するか、スキャンをコピーし直してください</translation>
    </message>
    <message>
        <source>%1 of the %2 images of this series are of another kind (%3)</source>
        <translation>このシリーズの画像 %2 枚中 %1 枚は種類が異なります (%3)</translation>
    </message>
    <message>
        <source>%1 and are left out: the scan may be cut there</source>
        <translation>%1。除外しました: そこでスキャンが欠けている可能性があります</translation>
    </message>
    <message>
        <source>%1, so that the others have gaps</source>
        <translation>%1。そのため残りに隙間があります</translation>
    </message>
    <message>
        <source>is a %1 archive</source>
        <translation>%1 のアーカイブファイルです</translation>
    </message>
    <message>
        <source>holds no DICOM images but a %1 archive (%2)</source>
        <translation>DICOM 画像がなく、%1 のアーカイブファイル (%2) があります</translation>
    </message>
    <message>
        <source>unpack it and give the folder</source>
        <translation>展開して、フォルダーを指定してください</translation>
    </message>
    <message>
        <source>is empty (0 bytes)</source>
        <translation>空です (0 バイト)</translation>
    </message>
    <message>
        <source>holds empty files only (%1 of 0 bytes)</source>
        <translation>空のファイルだけです (0 バイトが %1 個)</translation>
    </message>
    <message>
        <source>holds no DICOM images but NIfTI (%1)</source>
        <translation>DICOM 画像がなく、NIfTI (%1) があります</translation>
    </message>
    <message>
        <source>give that file</source>
        <translation>そのファイルを指定してください</translation>
    </message>
    <message>
        <source>holds no DICOM images</source>
        <translation>DICOM 画像がありません</translation>
    </message>
    <message>
        <source>give a folder of DICOM files or a .nii.gz</source>
        <translation>DICOM ファイルのフォルダー、または .nii.gz を指定してください</translation>
    </message>
    <message>
        <source>all slices</source>
        <translation>すべての断面</translation>
    </message>
    <message>
        <source>acquisition number</source>
        <translation>撮像番号</translation>
    </message>
    <message>
        <source>temporal position</source>
        <translation>時間位置</translation>
    </message>
    <message>
        <source>acquisition time</source>
        <translation>撮像時刻</translation>
    </message>
    <message>
        <source>repeated instance numbers</source>
        <translation>重複したインスタンス番号</translation>
    </message>
    <message>
        <source>instance order</source>
        <translation>インスタンス順</translation>
    </message>
    <message>
        <source>derived magnitude</source>
        <translation>派生した強度画像</translation>
    </message>
    <message>
        <source>no image type</source>
        <translation>画像種別なし</translation>
    </message>
    <message>
        <source>is not DICOM</source>
        <translation>DICOM ではありません</translation>
    </message>
    <message>
        <source>list the series again</source>
        <translation>シリーズを一覧し直してください</translation>
    </message>
    <message>
        <source>belongs to another series</source>
        <translation>別のシリーズのものです</translation>
    </message>
    <message>
        <source>the series holds no files</source>
        <translation>シリーズにファイルがありません</translation>
    </message>
    <message>
        <source>voxels and field of view fit navigation; the face is judged when it is prepared</source>
        <translation>ボクセルと撮像範囲はナビゲーションに適しています。顔は準備のときに判定します</translation>
    </message>
    <message>
        <source>DICOMDIR, a table of contents</source>
        <translation>DICOMDIR (目次)</translation>
    </message>
    <message>
        <source>structured report, no image</source>
        <translation>構造化レポート、画像なし</translation>
    </message>
    <message>
        <source>PDF document, no image</source>
        <translation>PDF 文書、画像なし</translation>
    </message>
    <message>
        <source>document, no image</source>
        <translation>文書、画像なし</translation>
    </message>
    <message>
        <source>radiation dose, no anatomical image</source>
        <translation>放射線量、解剖画像なし</translation>
    </message>
    <message>
        <source>radiotherapy structures, no image</source>
        <translation>放射線治療の構造、画像なし</translation>
    </message>
    <message>
        <source>radiotherapy plan or record, no image</source>
        <translation>放射線治療の計画または記録、画像なし</translation>
    </message>
    <message>
        <source>presentation state, no image</source>
        <translation>表示状態、画像なし</translation>
    </message>
    <message>
        <source>raw data, no image</source>
        <translation>生データ、画像なし</translation>
    </message>
    <message>
        <source>segmentation or registration object, no anatomical image</source>
        <translation>領域分割または位置合わせのオブジェクト、解剖画像なし</translation>
    </message>
    <message>
        <source>spectroscopy, no image</source>
        <translation>スペクトロスコピー、画像なし</translation>
    </message>
    <message>
        <source>waveform, no image</source>
        <translation>波形、画像なし</translation>
    </message>
    <message>
        <source>photograph, no volume</source>
        <translation>写真、ボリュームなし</translation>
    </message>
    <message>
        <source>secondary capture (a screenshot), no volume</source>
        <translation>二次取得 (画面の写し)、ボリュームなし</translation>
    </message>
    <message>
        <source>modality unknown</source>
        <translation>モダリティ不明</translation>
    </message>
    <message>
        <source>modality %1 is neither MR nor CT</source>
        <translation>モダリティ %1 は MR でも CT でもありません</translation>
    </message>
    <message>
        <source>mosaic: many slices tiled into one image</source>
        <translation>モザイク: 多数の断面を並べた 1 枚の画像</translation>
    </message>
    <message>
        <source>multi-frame image without a position for each frame</source>
        <translation>フレームごとの位置がないマルチフレーム画像</translation>
    </message>
    <message>
        <source>images in many directions (projections or a localizer), no volume</source>
        <translation>向きのばらばらな画像 (投影像または位置決め像)、ボリュームなし</translation>
    </message>
    <message>
        <source>holds %1 volumes of the same place (4-D)</source>
        <translation>同じ場所のボリュームが %1 個あります (4-D)</translation>
    </message>
    <message>
        <source>two different images lie at the same place (%1)</source>
        <translation>同じ場所に異なる 2 枚の画像があります (%1)</translation>
    </message>
    <message>
        <source>%1 duplicate image dropped</source>
        <translation>重複した画像 %1 枚を除きました</translation>
    </message>
    <message>
        <source>%1 duplicate images dropped</source>
        <translation>重複した画像 %1 枚を除きました</translation>
    </message>
    <message>
        <source>%1, not a T1-weighted image</source>
        <translation>%1、T1 強調画像ではありません</translation>
    </message>
    <message>
        <source>%1, not a magnitude</source>
        <translation>%1、強度画像ではありません</translation>
    </message>
    <message>
        <source>a phase image, a real part or an MP2RAGE UNI: its air lies in the middle of its values</source>
        <translation>位相画像、実部、または MP2RAGE UNI: 空気の値が値の範囲の中央にあります</translation>
    </message>
    <message>
        <source>CT: no brain model, the scalp only</source>
        <translation>CT: 脳モデルなし、頭皮のみ</translation>
    </message>
    <message>
        <source>T1 weighting not certain</source>
        <translation>T1 強調かどうか不確かです</translation>
    </message>
    <message>
        <source>voxels up to %1 mm (1.2 mm or finer is needed)</source>
        <translation>ボクセルが最大 %1 mm です (1.2 mm 以下が必要です)</translation>
    </message>
    <message>
        <source>voxels up to %1 mm, too coarse (1.2 mm or finer is needed)</source>
        <translation>ボクセルが最大 %1 mm で、粗すぎます (1.2 mm 以下が必要です)</translation>
    </message>
    <message>
        <source>does not cover the whole head</source>
        <translation>頭部全体を含んでいません</translation>
    </message>
    <message>
        <source>%1 of the %2 images that its headers speak of are not here</source>
        <translation>ヘッダーにある %2 枚の画像のうち %1 枚がありません</translation>
    </message>
    <message>
        <source>compressed, possibly with loss</source>
        <translation>圧縮あり、非可逆の可能性があります</translation>
    </message>
    <message>
        <source>stored with bright and dark exchanged (MONOCHROME1): read with dark air</source>
        <translation>明暗が逆に保存されています (MONOCHROME1): 空気を暗くして読み込みました</translation>
    </message>
    <message>
        <source>every image names another patient, as some anonymisers write it: taken as one patient, since all share one series UID</source>
        <translation>一部の匿名化ソフトの書き方で、画像ごとに患者名が異なります: シリーズ UID が共通のため、1 人の患者として扱います</translation>
    </message>
    <message>
        <source>with contrast agent</source>
        <translation>造影剤あり</translation>
    </message>
    <message>
        <source>%1: T1-weighted, its air may be noise</source>
        <translation>%1: T1 強調、空気の部分が雑音の可能性があります</translation>
    </message>
    <message>
        <source>dark fluid</source>
        <translation>水抑制</translation>
    </message>
    <message>
        <source>diffusion or EPI</source>
        <translation>拡散または EPI</translation>
    </message>
    <message>
        <source>its %1 stacks (Stack ID) were joined: together they are one even volume</source>
        <translation>%1 個のスタック (Stack ID) をつなぎました: 全体で 1 つの等間隔のボリュームになります</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>大きすぎます</translation>
    </message>
    <message>
        <source>has no Image Position (Patient)</source>
        <translation>Image Position (Patient) がありません</translation>
    </message>
    <message>
        <source>has no Image Orientation (Patient)</source>
        <translation>Image Orientation (Patient) がありません</translation>
    </message>
    <message>
        <source>has no Pixel Spacing</source>
        <translation>Pixel Spacing がありません</translation>
    </message>
    <message>
        <source>Image Orientation (Patient) is not two unit vectors at right angles</source>
        <translation>Image Orientation (Patient) が直交する 2 つの単位ベクトルではありません</translation>
    </message>
    <message>
        <source>Pixel Spacing of %1 is impossible</source>
        <translation>Pixel Spacing %1 はあり得ません</translation>
    </message>
    <message>
        <source>Image Position (Patient) is impossible</source>
        <translation>Image Position (Patient) があり得ない値です</translation>
    </message>
    <message>
        <source>%1 than the other images of the series</source>
        <translation>シリーズのほかの画像と比べて%1</translation>
    </message>
    <message>
        <source>has another matrix</source>
        <translation>行列の大きさが異なります</translation>
    </message>
    <message>
        <source>has another orientation</source>
        <translation>向きが異なります</translation>
    </message>
    <message>
        <source>has another Pixel Spacing</source>
        <translation>Pixel Spacing が異なります</translation>
    </message>
    <message>
        <source>holds a single slice</source>
        <translation>断面が 1 枚だけです</translation>
    </message>
    <message>
        <source>choose a series with many slices</source>
        <translation>断面の多いシリーズを選んでください</translation>
    </message>
    <message>
        <source>slices lie %1 apart</source>
        <translation>断面が %1 離れています</translation>
    </message>
    <message>
        <source>%1 slice is missing between %2</source>
        <translation>%2 の間で断面が %1 枚欠けています</translation>
    </message>
    <message>
        <source>%1 slices are missing between %2</source>
        <translation>%2 の間で断面が %1 枚欠けています</translation>
    </message>
    <message>
        <source>unequal slice spacing: %1 between %2, %3 elsewhere</source>
        <translation>断面間隔が不均一です: %2 の間で %1、ほかは %3</translation>
    </message>
    <message>
        <source>slice is</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>slices are</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>copy the whole series again</source>
        <translation>シリーズ全体をコピーし直してください</translation>
    </message>
    <message>
        <source>slices are sheared by %1 degrees (gantry tilt)</source>
        <translation>断面が %1 度ずれて積まれています (ガントリー傾斜)</translation>
    </message>
    <message>
        <source>resample the series or scan without tilt</source>
        <translation>シリーズを再サンプリングするか、傾斜なしで撮像してください</translation>
    </message>
    <message>
        <source>unequal slice spacing: slice lies %1 off its place in an even stack</source>
        <translation>断面間隔が不均一です: 断面が等間隔の位置から %1 ずれています</translation>
    </message>
    <message>
        <source>slice lies %1 beside the others</source>
        <translation>断面がほかの断面から横に %1 ずれています</translation>
    </message>
    <message>
        <source>slice positions are rounded; the mean spacing is used (dcm2niix continues the first gap, up to %1 off)</source>
        <translation>断面位置が丸められています。平均間隔を使います (dcm2niix は最初の間隔を続けるため、最大 %1 ずれます)</translation>
    </message>
    <message>
        <source>frame of reference</source>
        <translation>基準座標系</translation>
    </message>
    <message>
        <source>the volume&apos;s axes are not at right angles</source>
        <translation>ボリュームの軸が直交していません</translation>
    </message>
    <message>
        <source>resample it first</source>
        <translation>先に再サンプリングしてください</translation>
    </message>
    <message>
        <source>the volume&apos;s values do not fit into 16 bits</source>
        <translation>ボリュームの値が 16 ビットに収まりません</translation>
    </message>
    <message>
        <source>the volume is too large for DICOM</source>
        <translation>ボリュームが DICOM には大きすぎます</translation>
    </message>
    <message>
        <source>cannot be created (%1)</source>
        <translation>作成できません (%1)</translation>
    </message>
    <message>
        <source>the masks lie on different grids</source>
        <translation>マスクの格子が異なります</translation>
    </message>
    <message>
        <source>resample one of them</source>
        <translation>一方を再サンプリングしてください</translation>
    </message>
    <message>
        <source>the mask has too many voxels to be edited</source>
        <translation>マスクのボクセルが多すぎて修正できません</translation>
    </message>
    <message>
        <source>resample it</source>
        <translation>再サンプリングしてください</translation>
    </message>
    <message>
        <source>the edited mask lies on another grid than the automatic one</source>
        <translation>修正したマスクと自動マスクの格子が異なります</translation>
    </message>
    <message>
        <source>automatic mask</source>
        <translation>自動マスク</translation>
    </message>
    <message>
        <source>the place lies outside the scan</source>
        <translation>その場所はスキャンの外です</translation>
    </message>
    <message>
        <source>click inside it</source>
        <translation>中をクリックしてください</translation>
    </message>
    <message>
        <source>a slice to interpolate from lies outside the scan</source>
        <translation>補間に使う断面がスキャンの外です</translation>
    </message>
    <message>
        <source>choose slices of this scan</source>
        <translation>このスキャンの断面を選んでください</translation>
    </message>
    <message>
        <source>ask its administrator</source>
        <translation>管理者に問い合わせてください</translation>
    </message>
    <message>
        <source>the archive met an error of its own</source>
        <translation>アーカイブの内部でエラーが発生しました</translation>
    </message>
    <message>
        <source>try again, or %1</source>
        <translation>再試行するか、%1</translation>
    </message>
    <message>
        <source>the archive does not hold this object</source>
        <translation>アーカイブにこのオブジェクトがありません</translation>
    </message>
    <message>
        <source>search again</source>
        <translation>検索し直してください</translation>
    </message>
    <message>
        <source>the archive does not take this kind of object or request</source>
        <translation>アーカイブはこの種のオブジェクトまたは要求を受け付けません</translation>
    </message>
    <message>
        <source>the archive does not allow &apos;%1&apos; to do this</source>
        <translation>アーカイブは &apos;%1&apos; にこれを許可していません</translation>
    </message>
    <message>
        <source>the archive does not know this kind of request</source>
        <translation>アーカイブはこの種の要求に対応していません</translation>
    </message>
    <message>
        <source>the archive is out of resources and could not count the matches</source>
        <translation>アーカイブの資源が足りず、該当数を数えられませんでした</translation>
    </message>
    <message>
        <source>try again later</source>
        <translation>後で再試行してください</translation>
    </message>
    <message>
        <source>the archive could not send the images: it cannot convert them to a form that FaceNav reads, or is out of resources</source>
        <translation>アーカイブが画像を送れませんでした: FaceNav が読める形式に変換できないか、資源が足りません</translation>
    </message>
    <message>
        <source>have the series sent uncompressed or as JPEG 2000; or %1</source>
        <translation>シリーズを非圧縮か JPEG 2000 で送ってもらうか、%1</translation>
    </message>
    <message>
        <source>the archive does not know &apos;%1&apos; as a place to send to</source>
        <translation>アーカイブは送信先 &apos;%1&apos; を認識していません</translation>
    </message>
    <message>
        <source>have it entered there</source>
        <translation>アーカイブに登録してもらってください</translation>
    </message>
    <message>
        <source>it was cancelled</source>
        <translation>キャンセルされました</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>再試行してください</translation>
    </message>
    <message>
        <source>the archive is out of resources (disk or memory)</source>
        <translation>アーカイブの資源が足りません (ディスクまたはメモリー)</translation>
    </message>
    <message>
        <source>the archive finds that data and kind of object do not match</source>
        <translation>アーカイブによると、データとオブジェクトの種類が一致しません</translation>
    </message>
    <message>
        <source>check the UIDs</source>
        <translation>UID を確認してください</translation>
    </message>
    <message>
        <source>the archive could not process the request</source>
        <translation>アーカイブが要求を処理できませんでした</translation>
    </message>
    <message>
        <source>check the UIDs and the search&apos;s words, or %1</source>
        <translation>UID と検索語を確認するか、%1</translation>
    </message>
    <message>
        <source>the archive reports a failure</source>
        <translation>アーカイブが失敗を報告しました</translation>
    </message>
    <message>
        <source>asking for an echo</source>
        <translation>エコーの要求</translation>
    </message>
    <message>
        <source>the search is empty</source>
        <translation>検索条件が空です</translation>
    </message>
    <message>
        <source>give a patient id, a study date, or a study UID</source>
        <translation>患者 ID、検査日、または検査 UID を指定してください</translation>
    </message>
    <message>
        <source>searching the archive</source>
        <translation>アーカイブを検索しています</translation>
    </message>
    <message>
        <source>receiving images</source>
        <translation>画像を受信しています</translation>
    </message>
    <message>
        <source>&apos;facenav pacs find&apos; lists them</source>
        <translation>&apos;facenav pacs find&apos; で一覧できます</translation>
    </message>
    <message>
        <source>the archive offers no C-GET</source>
        <translation>アーカイブが C-GET に対応していません</translation>
    </message>
    <message>
        <source>%1 images could not be received</source>
        <translation>%1 枚の画像を受信できませんでした</translation>
    </message>
    <message>
        <source>the archive sent no image</source>
        <translation>アーカイブから画像が送られませんでした</translation>
    </message>
    <message>
        <source>%1 application entity title &apos;%2&apos; is impossible</source>
        <translation>%1 AE タイトル &apos;%2&apos; は使えません</translation>
    </message>
    <message>
        <source>1 to 16 plain characters</source>
        <translation>1〜16 文字の英数字</translation>
    </message>
    <message>
        <source>certificate or key is not there</source>
        <translation>証明書または鍵がありません</translation>
    </message>
    <message>
        <source>give a PEM file</source>
        <translation>PEM ファイルを指定してください</translation>
    </message>
    <message>
        <source>no archive host is given</source>
        <translation>アーカイブのホストが指定されていません</translation>
    </message>
    <message>
        <source>give its name or address</source>
        <translation>名前またはアドレスを入力してください</translation>
    </message>
    <message>
        <source>port %1 is impossible</source>
        <translation>ポート %1 は使えません</translation>
    </message>
    <message>
        <source>timeout is impossible</source>
        <translation>待ち時間が正しくありません</translation>
    </message>
    <message>
        <source>the archive&apos;s</source>
        <translation>アーカイブの</translation>
    </message>
    <message>
        <source>our own</source>
        <translation>自分の</translation>
    </message>
    <message>
        <source>setting up the network</source>
        <translation>ネットワークの準備</translation>
    </message>
    <message>
        <source>the archive offers none of the services asked for</source>
        <translation>アーカイブは要求したサービスのいずれにも対応していません</translation>
    </message>
    <message>
        <source>the archive refuses us (%1)</source>
        <translation>アーカイブが接続を拒否しました (%1)</translation>
    </message>
    <message>
        <source>have &apos;%1&apos; entered there, and check its title here</source>
        <translation>アーカイブに &apos;%1&apos; を登録してもらい、ここで AE タイトルを確認してください</translation>
    </message>
    <message>
        <source>the archive does not answer (%1)</source>
        <translation>アーカイブが応答しません (%1)</translation>
    </message>
    <message>
        <source>check host, port, firewall and TLS</source>
        <translation>ホスト、ポート、ファイアウォール、TLS を確認してください</translation>
    </message>
    <message>
        <source>failed while %1 (%2)</source>
        <translation>%1: 失敗しました (%2)</translation>
    </message>
    <message>
        <source>%1 while %2 (status 0x%3)</source>
        <translation>%2: %1 (状態 0x%3)</translation>
    </message>
    <message>
        <source>port %1 cannot be listened on</source>
        <translation>ポート %1 で待ち受けできません</translation>
    </message>
    <message>
        <source>close what uses it, or choose another that the archive knows</source>
        <translation>それを使っているものを閉じるか、アーカイブが認識する別のポートを選んでください</translation>
    </message>
    <message>
        <source>holds no DICOM files to send</source>
        <translation>送信する DICOM ファイルがありません</translation>
    </message>
    <message>
        <source>holds too many kinds of objects for one connection</source>
        <translation>1 回の接続で送るにはオブジェクトの種類が多すぎます</translation>
    </message>
    <message>
        <source>send them in parts</source>
        <translation>分けて送信してください</translation>
    </message>
    <message>
        <source>sending images</source>
        <translation>画像を送信しています</translation>
    </message>
    <message>
        <source>the archive does not take this kind of object or its compression</source>
        <translation>アーカイブはこの種のオブジェクトまたはその圧縮を受け付けません</translation>
    </message>
    <message>
        <source>growing the brain&apos;s surface</source>
        <translation>脳の表面を拡張しています</translation>
    </message>
    <message>
        <source>no brain can be modelled: %1</source>
        <translation>脳をモデル化できません: %1</translation>
    </message>
    <message>
        <source>a T1-weighted MR of the whole head is needed</source>
        <translation>頭部全体の T1 強調 MR が必要です</translation>
    </message>
    <message>
        <source>this is a CT, in which grey and white matter look alike</source>
        <translation>CT のため、灰白質と白質が同じように見えます</translation>
    </message>
    <message>
        <source>the scan covers only %1 mm in one direction</source>
        <translation>スキャンの範囲が 1 方向に %1 mm しかありません</translation>
    </message>
    <message>
        <source>grey and white matter do not differ in this scan</source>
        <translation>このスキャンでは灰白質と白質に差がありません</translation>
    </message>
    <message>
        <source>there is no head in this volume</source>
        <translation>このボリュームに頭部がありません</translation>
    </message>
    <message>
        <source>the tissues within the head all look alike, as on a CT</source>
        <translation>頭の中の組織がすべて同じように見えます (CT のような画像)</translation>
    </message>
    <message>
        <source>what looks like a brain measures %1 (%2 to %3 is possible in this head)</source>
        <translation>脳らしいものの体積は %1 です (この頭部であり得るのは %2〜%3)</translation>
    </message>
    <message>
        <source>the brain is cut by the scan&apos;s edge at the %1</source>
        <translation>脳がスキャンの端で切れています (%1)</translation>
    </message>
    <message>
        <source>the slices are thicker than 3 mm: the brain&apos;s surface is coarse</source>
        <translation>断面が 3 mm より厚くなっています: 脳の表面は粗くなります</translation>
    </message>
    <message>
        <source>grey and white matter alone do not give the brain&apos;s outline: check it</source>
        <translation>灰白質と白質だけでは脳の輪郭が定まりません: 確認してください</translation>
    </message>
    <message>
        <source>this scan does not look like a T1 but like %1: the brain&apos;s outline is less sure; a T1-weighted MR of the whole head is better</source>
        <translation>このスキャンは T1 ではなく %1 のようです: 脳の輪郭の確かさが下がります。頭部全体の T1 強調 MR が望まれます</translation>
    </message>
    <message>
        <source>no brain can be modelled: nothing in this CT looks like one (a phantom, another part of the body, or a face alone)</source>
        <translation>脳をモデル化できません: この CT に脳らしいものがありません (ファントム、ほかの部位、または顔だけ)</translation>
    </message>
    <message>
        <source>fitting the brain&apos;s outline</source>
        <translation>脳の輪郭を合わせています</translation>
    </message>
    <message>
        <source>this is a CT, in which grey and white matter look alike: the brain&apos;s outline is the learned prior&apos;s, within the skull, and sure to some millimetres only; a T1-weighted MR of the whole head is better</source>
        <translation>CT のため、灰白質と白質が同じように見えます: 脳の輪郭は頭蓋内で学習済みの事前分布から求めたもので、精度は数 mm です。頭部全体の T1 強調 MR が望まれます</translation>
    </message>
    <message>
        <source>without the learned brain prior: %1</source>
        <translation>学習済みの脳の事前分布なし: %1</translation>
    </message>
    <message>
        <source>looking for the brain</source>
        <translation>脳を探しています</translation>
    </message>
    <message>
        <source>the learned brain prior sees no brain in this scan: check the outline everywhere</source>
        <translation>学習済みの脳の事前分布では、このスキャンに脳が見つかりません: 輪郭をすべて確認してください</translation>
    </message>
    <message>
        <source>there is nothing where the brain should be</source>
        <translation>脳があるべき場所に何もありません</translation>
    </message>
    <message>
        <source>the volume has no contrast</source>
        <translation>ボリュームにコントラストがありません</translation>
    </message>
    <message>
        <source>the largest object is %1 mm across, which is no head</source>
        <translation>最大の物体の大きさが %1 mm で、頭部ではありません</translation>
    </message>
    <message>
        <source>T1 (weak: fluid is not much darker than grey matter)</source>
        <translation>T1 (弱い: 髄液が灰白質よりわずかに暗いだけ)</translation>
    </message>
    <message>
        <source>T2 (fluid is brighter than the brain)</source>
        <translation>T2 (髄液が脳より明るい)</translation>
    </message>
    <message>
        <source>FLAIR (white matter is darker than grey, fluid is dark)</source>
        <translation>FLAIR (白質が灰白質より暗く、髄液が暗い)</translation>
    </message>
    <message>
        <source>proton density (fluid and brain are alike)</source>
        <translation>プロトン密度 (髄液と脳が同じように見える)</translation>
    </message>
    <message>
        <source>nothing in this CT looks like one</source>
        <translation>この CT に脳らしいものがありません</translation>
    </message>
    <message>
        <source>what looks like a brain in this CT measures %1 Hounsfield units (a brain has 20 to 45)</source>
        <translation>この CT で脳らしいものの値は %1 ハウンスフィールド単位です (脳は 20〜45)</translation>
    </message>
    <message>
        <source>in this CT no skull lies around what looks like a brain (bone outside %1 % of it): a phantom, or another part of the body</source>
        <translation>この CT では、脳らしいもののまわりに頭蓋骨がありません (骨があるのは周囲の %1 %): ファントムか、ほかの部位です</translation>
    </message>
    <message>
        <source>measuring grey and white matter</source>
        <translation>灰白質と白質を計測しています</translation>
    </message>
    <message>
        <source>separating the brain</source>
        <translation>脳を分離しています</translation>
    </message>
    <message>
        <source>asking how sure the brain&apos;s surface is</source>
        <translation>脳の表面の確かさを調べています</translation>
    </message>
    <message>
        <source>head mask</source>
        <translation>頭部マスク</translation>
    </message>
    <message>
        <source>no head in this volume: it is empty</source>
        <translation>このボリュームに頭部がありません: 空です</translation>
    </message>
    <message>
        <source>the air around the head is noisy: the skin may be placed less accurately</source>
        <translation>頭のまわりの空気に雑音があります: 皮膚の位置の精度が下がる可能性があります</translation>
    </message>
    <message>
        <source>no head in this volume: nothing stands out from the noise</source>
        <translation>このボリュームに頭部がありません: 雑音と区別できるものがありません</translation>
    </message>
    <message>
        <source>choose a T1 or CT series that shows the whole head</source>
        <translation>頭部全体が写った T1 または CT のシリーズを選んでください</translation>
    </message>
    <message>
        <source>no head in this volume: nothing of a head&apos;s size stands out from the background</source>
        <translation>このボリュームに頭部がありません: 頭部ほどの大きさで背景と区別できるものがありません</translation>
    </message>
    <message>
        <source>no head in this volume: there is no air around it</source>
        <translation>このボリュームに頭部がありません: まわりに空気がありません</translation>
    </message>
    <message>
        <source>pads and earphones could not be told from skin, because the learned brain prior found no brain: compare the skin with the slices</source>
        <translation>学習済みの脳の事前分布で脳が見つからないため、パッドやイヤホンと皮膚を区別できませんでした: 皮膚と断面を見比べてください</translation>
    </message>
    <message>
        <source>pads and earphones could not be told from skin, because the learned brain prior is missing or damaged: compare the skin with the slices</source>
        <translation>学習済みの脳の事前分布がないか壊れているため、パッドやイヤホンと皮膚を区別できませんでした: 皮膚と断面を見比べてください</translation>
    </message>
    <message>
        <source>pads, earphones or haze that touch the head (%1 ml) were left out; the skin beneath them is less sure</source>
        <translation>頭に触れているパッド、イヤホン、またはもや (%1 ml) を除きました。その下の皮膚の確かさは下がります</translation>
    </message>
    <message>
        <source>a faint haze surrounds the head (%1 % of the skin&apos;s signal); it was not taken for skin</source>
        <translation>頭のまわりに薄いもやがあります (皮膚の信号の %1 %)。皮膚とは見なしていません</translation>
    </message>
    <message>
        <source>the brain prior&apos;s weights are not of this network</source>
        <translation>脳の事前分布の重みがこのネットワークのものではありません</translation>
    </message>
    <message>
        <source>install FaceNav anew</source>
        <translation>FaceNav をインストールし直してください</translation>
    </message>
    <message>
        <source>no brain can be modelled: nothing in this scan looks like one</source>
        <translation>脳をモデル化できません: このスキャンに脳らしいものがありません</translation>
    </message>
    <message>
        <source>ends too early</source>
        <translation>途中で終わっています</translation>
    </message>
    <message>
        <source>holds a size that is not possible</source>
        <translation>あり得ない大きさを含んでいます</translation>
    </message>
    <message>
        <source>the brain prior&apos;s weights cannot be used: the file %1</source>
        <translation>脳の事前分布の重みを使えません: ファイルが%1</translation>
    </message>
    <message>
        <source>the brain prior&apos;s weights are missing</source>
        <translation>脳の事前分布の重みがありません</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>壊れています</translation>
    </message>
    <message>
        <source>is of another kind</source>
        <translation>別の種類です</translation>
    </message>
    <message>
        <source>is of another version</source>
        <translation>別のバージョンです</translation>
    </message>
    <message>
        <source>is longer than it says</source>
        <translation>記載より長くなっています</translation>
    </message>
    <message>
        <source>the sulci cannot be opened: white matter is darker than grey matter</source>
        <translation>脳溝を開けません: 白質が灰白質より暗くなっています</translation>
    </message>
    <message>
        <source>a T1-weighted MR is needed</source>
        <translation>T1 強調 MR が必要です</translation>
    </message>
    <message>
        <source>opening the sulci</source>
        <translation>脳溝を開いています</translation>
    </message>
    <message>
        <source>no such texture file</source>
        <translation>そのテクスチャーファイルはありません</translation>
    </message>
    <message>
        <source>not a PNG picture</source>
        <translation>PNG 画像ではありません</translation>
    </message>
    <message>
        <source>damaged texture picture</source>
        <translation>壊れたテクスチャー画像です</translation>
    </message>
    <message>
        <source>the brain surface has no field &apos;%1&apos; that fits its texture</source>
        <translation>脳の表面に、テクスチャーに合う項目 &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>the texture could not be written</source>
        <translation>テクスチャーを書き込めませんでした</translation>
    </message>
    <message>
        <source>is the disk full?</source>
        <translation>ディスクに空きがありますか?</translation>
    </message>
    <message>
        <source>the brain surface has no texture coordinates</source>
        <translation>脳の表面にテクスチャー座標がありません</translation>
    </message>
    <message>
        <source>meshing the brain&apos;s surface</source>
        <translation>脳の表面をメッシュ化しています</translation>
    </message>
    <message>
        <source>extracting the brain&apos;s surface</source>
        <translation>脳の表面を抽出しています</translation>
    </message>
    <message>
        <source>the brain has no surface</source>
        <translation>脳に表面がありません</translation>
    </message>
    <message>
        <source>segment the brain, or paint it</source>
        <translation>脳を領域分割するか、描き込んでください</translation>
    </message>
    <message>
        <source>smoothing the brain&apos;s surface</source>
        <translation>脳の表面を平滑化しています</translation>
    </message>
    <message>
        <source>the cortex has no distances to the phi-theta surface</source>
        <translation>皮質に φ–θ 面までの距離がありません</translation>
    </message>
    <message>
        <source>the brain mask is empty</source>
        <translation>脳マスクが空です</translation>
    </message>
    <message>
        <source>the brain mask is too small for a surface</source>
        <translation>脳マスクが小さすぎて表面を作れません</translation>
    </message>
    <message>
        <source>the brain mask has no surface around its centre</source>
        <translation>脳マスクの中心のまわりに表面がありません</translation>
    </message>
    <message>
        <source>a brain model needs at least 4 x 4 bins</source>
        <translation>脳モデルには 4 x 4 以上の区画が必要です</translation>
    </message>
    <message>
        <source>mapping the brain&apos;s surface</source>
        <translation>脳の表面を展開しています</translation>
    </message>
    <message>
        <source>points of the face below are not used</source>
        <translation>その下の顔の点は使いません</translation>
    </message>
    <message>
        <source>the scan ends at mid-nose: alignment rests on forehead, brow and eyes%1</source>
        <translation>スキャンが鼻の中央で終わっています: 位置合わせは前額、眉、目によります%1</translation>
    </message>
    <message>
        <source>the scan ends at the upper lip%1</source>
        <translation>スキャンが上唇で終わっています%1</translation>
    </message>
    <message>
        <source>the scan ends above the chin%1</source>
        <translation>スキャンがオトガイより上で終わっています%1</translation>
    </message>
    <message>
        <source>the face was removed below the brow (a defaced scan): there is no face to align to</source>
        <translation>眉から下の顔が消されています (顔を消したスキャン): 位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>the face was blurred or smoothed by a program (a defaced scan): its skin is not the person&apos;s</source>
        <translation>顔がプログラムでぼかされているか、平滑化されています (顔を消したスキャン): 本人の皮膚ではありません</translation>
    </message>
    <message>
        <source>the scan&apos;s edge cuts the face off: there is no face to align to</source>
        <translation>スキャンの端で顔が切れています: 位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>the scan ends above the nose: there is no face to align to</source>
        <translation>スキャンが鼻より上で終わっています: 位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>brow, eyes and nose are hard to make out (partly removed, smoothed or unusual): look at the skin before aligning</source>
        <translation>眉、目、鼻がはっきりしません (一部が消されている、平滑化されている、または形が通常と異なる): 位置合わせの前に皮膚を確認してください</translation>
    </message>
    <message>
        <source>the nose tip is cut by the scan&apos;s edge</source>
        <translation>鼻尖がスキャンの端で切れています</translation>
    </message>
    <message>
        <source>the forehead touches the scan&apos;s edge</source>
        <translation>前額がスキャンの端に触れています</translation>
    </message>
    <message>
        <source>an ear is cut by the scan&apos;s edge</source>
        <translation>耳がスキャンの端で切れています</translation>
    </message>
    <message>
        <source>a 3-D T1 (MPRAGE, BRAVO, TFE) with voxels of 1 mm, at most 1.2 mm</source>
        <translation>ボクセル 1 mm (最大 1.2 mm) の 3-D T1 (MPRAGE、BRAVO、TFE)</translation>
    </message>
    <message>
        <source>a field of view from above the vertex to below the chin, with 10 mm of air around nose and ears</source>
        <translation>頭頂の上からオトガイの下までの撮像範囲。鼻と耳のまわりに 10 mm の空気</translation>
    </message>
    <message>
        <source>there is no face to align to</source>
        <translation>位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>the original, not defaced images; %1</source>
        <translation>顔を消していない元の画像。%1</translation>
    </message>
    <message>
        <source>brow, eyes and nose are there, whole</source>
        <translation>眉、目、鼻がそろっています</translation>
    </message>
    <message>
        <source>both ears lie within the field of view</source>
        <translation>両耳が撮像範囲にあります</translation>
    </message>
    <message>
        <source>both sides of the head are cut by the field of view: no measure over the ears, and targets far to the side lack their scalp</source>
        <translation>頭の両側が撮像範囲で切れています: 両耳間の計測ができず、外側の標的には頭皮がありません</translation>
    </message>
    <message>
        <source>the right side of the head is cut by the field of view: no measure over the ears, and targets far to the side lack their scalp</source>
        <translation>患者の頭の右側が撮像範囲で切れています: 両耳間の計測ができず、外側の標的には頭皮がありません</translation>
    </message>
    <message>
        <source>the left side of the head is cut by the field of view: no measure over the ears, and targets far to the side lack their scalp</source>
        <translation>患者の頭の左側が撮像範囲で切れています: 両耳間の計測ができず、外側の標的には頭皮がありません</translation>
    </message>
    <message>
        <source>the top of the head lies within the field of view</source>
        <translation>頭頂が撮像範囲にあります</translation>
    </message>
    <message>
        <source>the top of the head is cut over %1 cm2: targets there have no scalp</source>
        <translation>頭頂が %1 cm2 にわたって切れています: そこの標的には頭皮がありません</translation>
    </message>
    <message>
        <source>voxels of %1 to %2 mm</source>
        <translation>ボクセル %1〜%2 mm</translation>
    </message>
    <message>
        <source>%1: the skin is placed less well than with 1 mm</source>
        <translation>%1: 1 mm の場合より皮膚の位置の精度が下がります</translation>
    </message>
    <message>
        <source>%1: too coarse to place skin or cortex</source>
        <translation>%1: 皮膚や皮質の位置を決めるには粗すぎます</translation>
    </message>
    <message>
        <source>not measurable, the air around the head was erased; the skin&apos;s edge is clear</source>
        <translation>計測できません。頭のまわりの空気が消されていますが、皮膚の縁は明瞭です</translation>
    </message>
    <message>
        <source>not measurable, the scan holds no air beside the head</source>
        <translation>計測できません。スキャンに頭の横の空気がありません</translation>
    </message>
    <message>
        <source>the noise moves the skin by %1 mm (signal to noise %2)</source>
        <translation>雑音による皮膚のずれは %1 mm です (信号雑音比 %2)</translation>
    </message>
    <message>
        <source>a head coil with more channels, less acceleration, or two averages</source>
        <translation>チャンネル数の多いヘッドコイル、加速率の引き下げ、または 2 回加算</translation>
    </message>
    <message>
        <source>not measurable, this is a CT or its air holds negative values</source>
        <translation>計測できません。CT であるか、空気に負の値があります</translation>
    </message>
    <message>
        <source>not measurable, there is no untouched air beside the head</source>
        <translation>計測できません。頭の横に手の加わっていない空気がありません</translation>
    </message>
    <message>
        <source>ghosts in the air beside the head reach %1 % of the skin&apos;s signal (%2): the head moved, or an artefact</source>
        <translation>頭の横の空気のゴーストが皮膚の信号の %1 % に達しています (%2): 頭の動き、またはアーチファクト</translation>
    </message>
    <message>
        <source>ghosts in the air beside the head reach %1 % of the skin&apos;s signal</source>
        <translation>頭の横の空気のゴーストが皮膚の信号の %1 % に達しています</translation>
    </message>
    <message>
        <source>the scan again, head padded still, phase encoding left-right so that ghosts miss the face</source>
        <translation>頭をパッドで固定しての再撮像。ゴーストが顔に重ならないよう、位相エンコードは左右方向</translation>
    </message>
    <message>
        <source>it ends in dark air where coils go</source>
        <translation>コイルを当てる場所の周囲は暗い空気です</translation>
    </message>
    <message>
        <source>over %1 cm2 of the upper head the skin is unsure by more than 0.5 mm, and so is the coil&apos;s gap: pads, earphones or haze lie against it, or its edge is drawn out</source>
        <translation>頭の上部の %1 cm2 で、皮膚の位置の不確かさが 0.5 mm を超え、コイルの隙間も同様に不確かです: パッド、イヤホン、もやが触れているか、縁が引き伸ばされています</translation>
    </message>
    <message>
        <source>a scan with nothing but air at forehead and crown, or pads without signal</source>
        <translation>前額と頭頂に空気以外のないスキャン、または信号の出ないパッド</translation>
    </message>
    <message>
        <source>the %1 (%2 % of what is cut opposite)</source>
        <translation>%1 (反対側で切れた分の %2 %)</translation>
    </message>
    <message>
        <source>and the %1 (%2 % of what is cut opposite)</source>
        <translation>および %1 (反対側で切れた分の %2 %)</translation>
    </message>
    <message>
        <source>nothing appears on the wrong side of the scan</source>
        <translation>スキャンの反対側への折り返しはありません</translation>
    </message>
    <message>
        <source>tissue of the opposite side appears at %1 of the scan: the face may be cut or covered, look at the skin of face and back</source>
        <translation>反対側の組織がスキャンの %1 に現れています: 顔が切れているか隠れている可能性があります。顔と背面の皮膚を確認してください</translation>
    </message>
    <message>
        <source>tissue of the opposite side appears at %1 of the scan</source>
        <translation>反対側の組織がスキャンの %1 に現れています</translation>
    </message>
    <message>
        <source>phase oversampling, or a larger field of view</source>
        <translation>位相オーバーサンプリング、またはより広い撮像範囲</translation>
    </message>
    <message>
        <source>rest on Image Position and Orientation (Patient), as the scanner wrote them; a wrong patient position entered at the scanner cannot be seen here</source>
        <translation>装置が記録した Image Position と Orientation (Patient) によります。装置での患者体位の入力誤りはここでは分かりません</translation>
    </message>
    <message>
        <source>rest on the file&apos;s %1, which any program on the way may have changed: compare a mole, a scar or the parting with the person</source>
        <translation>ファイルの %1 によります。途中のどのプログラムでも変わり得ます: ほくろ、傷あと、髪の分け目を本人と比べてください</translation>
    </message>
    <message>
        <source>the DICOM images, or a capsule taped to the right temple</source>
        <translation>DICOM 画像、または右こめかみにカプセルを貼った撮像</translation>
    </message>
    <message>
        <source>no landmark was found, so nothing can be held against the person</source>
        <translation>ランドマークが見つからず、本人と比べられるものがありません</translation>
    </message>
    <message>
        <source>%1 measures of face and head lie within the adult range</source>
        <translation>顔と頭の計測値 %1 個が成人の範囲内です</translation>
    </message>
    <message>
        <source>outside the adult range: %1; a child, another population, a template head or a wrong voxel size: measure the person</source>
        <translation>成人の範囲外: %1。小児、ほかの集団、テンプレートの頭部、またはボクセルの大きさの誤り: 本人を計測してください</translation>
    </message>
    <message>
        <source>is no verdict (fine, caution, not usable)</source>
        <translation>判定ではありません (fine、caution、not usable)</translation>
    </message>
    <message>
        <source>is no topic of the import check</source>
        <translation>取り込み確認の項目ではありません</translation>
    </message>
    <message>
        <source>%1, %2: %3; ask for %4</source>
        <translation>%1、%2: %3。依頼する撮像: %4</translation>
    </message>
    <message>
        <source>lid centre%1</source>
        <translation>まぶたの中心%1</translation>
    </message>
    <message>
        <source>circumference of the head</source>
        <translation>頭囲</translation>
    </message>
    <message>
        <source>there is no landmark &apos;%1&apos;</source>
        <translation>ランドマーク &apos;%1&apos; はありません</translation>
    </message>
    <message>
        <source>choose nasion, inion, tragus-left or tragus-right</source>
        <translation>nasion、inion、tragus-left、tragus-right のいずれかを選んでください</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no source of a landmark: skin, atlas or hand was expected</source>
        <translation>&apos;%1&apos; はランドマークの由来ではありません: skin、atlas、hand のいずれかが必要です</translation>
    </message>
    <message>
        <source>the %1 is not known</source>
        <translation>%1 が不明です</translation>
    </message>
    <message>
        <source>set it by hand: in Plan at the crosshair, or facenav plan CASE --set-landmark %1=X,Y,Z</source>
        <translation>手動で設定してください: 計画の画面の十字線、または facenav plan CASE --set-landmark %1=X,Y,Z</translation>
    </message>
    <message>
        <source>a surface without triangles has no nearest point</source>
        <translation>三角形のない表面には最近傍点がありません</translation>
    </message>
    <message>
        <source>the surface cannot be read: %1</source>
        <translation>表面を読み込めません: %1</translation>
    </message>
    <message>
        <source>it is damaged or of another kind</source>
        <translation>壊れているか、別の種類です</translation>
    </message>
    <message>
        <source>it holds no point</source>
        <translation>点がありません</translation>
    </message>
    <message>
        <source>a coordinate is no number</source>
        <translation>座標が数値ではありません</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>種類 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>it holds no triangle</source>
        <translation>三角形がありません</translation>
    </message>
    <message>
        <source>a line names a missing point</source>
        <translation>線が存在しない点を示しています</translation>
    </message>
    <message>
        <source>it holds no line</source>
        <translation>線がありません</translation>
    </message>
    <message>
        <source>the surface is empty, nothing to write</source>
        <translation>表面が空で、書き出すものがありません</translation>
    </message>
    <message>
        <source>the surface could not be written</source>
        <translation>表面を書き込めませんでした</translation>
    </message>
    <message>
        <source>a mesh of triangles was expected, a polygon of %1 corners found</source>
        <translation>三角形のメッシュが必要ですが、%1 角形があります</translation>
    </message>
    <message>
        <source>a triangle names a point that is not there</source>
        <translation>三角形が存在しない点を示しています</translation>
    </message>
    <message>
        <source>the surface could not be encoded</source>
        <translation>表面を符号化できませんでした</translation>
    </message>
    <message>
        <source>no such surface file</source>
        <translation>その表面のファイルはありません</translation>
    </message>
    <message>
        <source>not a VTK surface (.vtp)</source>
        <translation>VTK の表面 (.vtp) ではありません</translation>
    </message>
    <message>
        <source>damaged surface file</source>
        <translation>壊れた表面のファイルです</translation>
    </message>
    <message>
        <source>no way along the scalp leads from one place to the other</source>
        <translation>頭皮に沿って一方の場所からもう一方へ至る経路がありません</translation>
    </message>
    <message>
        <source>the scan cuts the skin between them</source>
        <translation>その間の皮膚がスキャンで切れています</translation>
    </message>
    <message>
        <source>a tape needs three places that do not lie on one line</source>
        <translation>巻尺には一直線上にない 3 か所が必要です</translation>
    </message>
    <message>
        <source>a tape between these places does not lie on the scalp</source>
        <translation>この場所を通る巻尺が頭皮上を通りません</translation>
    </message>
    <message>
        <source>no tape can be laid there: there is no skin</source>
        <translation>そこに巻尺を当てられません: 皮膚がありません</translation>
    </message>
    <message>
        <source>no tape of %1 mm can be laid there: the skin ends</source>
        <translation>そこに %1 mm の巻尺を当てられません: 皮膚が途切れています</translation>
    </message>
    <message>
        <source>choose a smaller distance</source>
        <translation>より短い距離を選んでください</translation>
    </message>
    <message>
        <source>the file holds more than one value a vertex</source>
        <translation>ファイルに 1 頂点あたり複数の値があります</translation>
    </message>
    <message>
        <source>export the magnitude alone</source>
        <translation>大きさだけを書き出してください</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>ファイルが途中で終わっています</translation>
    </message>
    <message>
        <source>is no readable GIFTI file</source>
        <translation>読み込める GIFTI ファイルではありません</translation>
    </message>
    <message>
        <source>the GIFTI file holds numbers of an unknown type</source>
        <translation>GIFTI ファイルの数値の型が不明です</translation>
    </message>
    <message>
        <source>export one of them</source>
        <translation>1 つだけを書き出してください</translation>
    </message>
    <message>
        <source>the GIFTI file holds no value a vertex</source>
        <translation>GIFTI ファイルに頂点ごとの値がありません</translation>
    </message>
    <message>
        <source>export the field&apos;s magnitude</source>
        <translation>電場の大きさを書き出してください</translation>
    </message>
    <message>
        <source>is no file with a value a vertex</source>
        <translation>頂点ごとの値を持つファイルではありません</translation>
    </message>
    <message>
        <source>give a FreeSurfer curv or a GIFTI file</source>
        <translation>FreeSurfer の curv または GIFTI ファイルを指定してください</translation>
    </message>
    <message>
        <source>holds a value that is no number</source>
        <translation>数値でない値があります</translation>
    </message>
    <message>
        <source>is no GIFTI surface</source>
        <translation>GIFTI の表面ではありません</translation>
    </message>
    <message>
        <source>give the .gii file of the surface</source>
        <translation>表面の .gii ファイルを指定してください</translation>
    </message>
    <message>
        <source>the GIFTI file holds no surface</source>
        <translation>GIFTI ファイルに表面がありません</translation>
    </message>
    <message>
        <source>give the file with the coordinates</source>
        <translation>座標のあるファイルを指定してください</translation>
    </message>
    <message>
        <source>the surface lies in the space of a template</source>
        <translation>表面がテンプレートの空間にあります</translation>
    </message>
    <message>
        <source>give the surface in the subject&apos;s space</source>
        <translation>被験者の空間の表面を指定してください</translation>
    </message>
    <message>
        <source>the surface has a triangle of a vertex that is not there</source>
        <translation>存在しない頂点の三角形が表面にあります</translation>
    </message>
    <message>
        <source>holds a coordinate that is no number</source>
        <translation>数値でない座標があります</translation>
    </message>
    <message>
        <source>holds no point data &apos;%1&apos; of three components</source>
        <translation>3 成分の点データ &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>export the field with the surface</source>
        <translation>電場を表面とともに書き出してください</translation>
    </message>
    <message>
        <source>not a scalp file: %1</source>
        <translation>頭皮のファイルではありません: %1</translation>
    </message>
    <message>
        <source>face_measurement needs 5 components</source>
        <translation>face_measurement には 5 成分が必要です</translation>
    </message>
    <message>
        <source>face_measurement is no standard error</source>
        <translation>face_measurement が標準誤差ではありません</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>三角形なし</translation>
    </message>
    <message>
        <source>doubt_mm needs 1 component</source>
        <translation>doubt_mm には 1 成分が必要です</translation>
    </message>
    <message>
        <source>no field has_face</source>
        <translation>項目 has_face がありません</translation>
    </message>
    <message>
        <source>a cut ear without a finding</source>
        <translation>耳が切れているのに所見がありません</translation>
    </message>
    <message>
        <source>field_of_view_mm needs 6 components</source>
        <translation>field_of_view_mm には 6 成分が必要です</translation>
    </message>
    <message>
        <source>no scalp: the head mask is empty</source>
        <translation>頭皮がありません: 頭部マスクが空です</translation>
    </message>
    <message>
        <source>redo the head mask</source>
        <translation>頭部マスクを作り直してください</translation>
    </message>
    <message>
        <source>head mask and volume lie on different grids</source>
        <translation>頭部マスクとボリュームの格子が異なります</translation>
    </message>
    <message>
        <source>mrtrix tracks</source>
        <translation>mrtrix tracks</translation>
    </message>
    <message>
        <source>it is no .tck file</source>
        <translation>.tck ファイルではありません</translation>
    </message>
    <message>
        <source>it is cut short</source>
        <translation>途中で切れています</translation>
    </message>
    <message>
        <source>its header does not say where its data begin</source>
        <translation>ヘッダーにデータの開始位置がありません</translation>
    </message>
    <message>
        <source>its data type &apos;%1&apos; is not known</source>
        <translation>データ型 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>the tracts cannot be read: %1</source>
        <translation>神経線維束を読み込めません: %1</translation>
    </message>
    <message>
        <source>it is no .trk file</source>
        <translation>.trk ファイルではありません</translation>
    </message>
    <message>
        <source>it is big-endian</source>
        <translation>ビッグエンディアンです</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>ヘッダーが壊れています</translation>
    </message>
    <message>
        <source>its header does not say where its voxels lie (vox_to_ras)</source>
        <translation>ヘッダーにボクセルの位置 (vox_to_ras) がありません</translation>
    </message>
    <message>
        <source>its voxel order &apos;%1&apos; is not known</source>
        <translation>ボクセルの順序 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>壊れています</translation>
    </message>
    <message>
        <source>it holds no positions</source>
        <translation>位置がありません</translation>
    </message>
    <message>
        <source>it holds no offsets</source>
        <translation>オフセットがありません</translation>
    </message>
    <message>
        <source>it holds no header.json</source>
        <translation>header.json がありません</translation>
    </message>
    <message>
        <source>it holds fewer points than it states</source>
        <translation>点の数が記載より少なくなっています</translation>
    </message>
    <message>
        <source>its lines do not fit its points</source>
        <translation>線と点が合いません</translation>
    </message>
    <message>
        <source>not enough memory to compress a file</source>
        <translation>ファイルを圧縮するメモリーが足りません</translation>
    </message>
    <message>
        <source>the map has no value within %1 mm of %2 %3 %4</source>
        <translation>%2 %3 %4 から %1 mm 以内にマップの値がありません</translation>
    </message>
    <message>
        <source>check the place, and whether the map is in MNI or the patient&apos;s space</source>
        <translation>場所と、マップが MNI か患者の空間かを確認してください</translation>
    </message>
    <message>
        <source>the map has one value everywhere in that region</source>
        <translation>その領域ではマップの値がすべて同じです</translation>
    </message>
    <message>
        <source>check the region</source>
        <translation>領域を確認してください</translation>
    </message>
    <message>
        <source>the file does not say that the map lies in a template&apos;s space</source>
        <translation>マップがテンプレートの空間にあることがファイルに書かれていません</translation>
    </message>
    <message>
        <source>give --map-space mni, or --map-space mri if it lies on the patient&apos;s MRI</source>
        <translation>--map-space mni を、患者の MRI の上にあるなら --map-space mri を指定してください</translation>
    </message>
    <message>
        <source>the file says that the map lies in a template&apos;s space, not the patient&apos;s</source>
        <translation>ファイルによると、マップは患者ではなくテンプレートの空間にあります</translation>
    </message>
    <message>
        <source>give --map-space mni</source>
        <translation>--map-space mni を指定してください</translation>
    </message>
    <message>
        <source>NIfTI file is truncated or damaged</source>
        <translation>NIfTI ファイルが途中で切れているか、壊れています</translation>
    </message>
    <message>
        <source>not enough memory for this volume</source>
        <translation>このボリュームにはメモリーが足りません</translation>
    </message>
    <message>
        <source>is not a file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>name a NIfTI file</source>
        <translation>NIfTI ファイルを指定してください</translation>
    </message>
    <message>
        <source>is NIfTI-2, which is not read</source>
        <translation>NIfTI-2 です。読み込めません</translation>
    </message>
    <message>
        <source>save it as NIfTI-1 (.nii.gz)</source>
        <translation>NIfTI-1 (.nii.gz) で保存してください</translation>
    </message>
    <message>
        <source>is not a NIfTI file</source>
        <translation>NIfTI ファイルではありません</translation>
    </message>
    <message>
        <source>export it again as .nii.gz</source>
        <translation>.nii.gz で書き出し直してください</translation>
    </message>
    <message>
        <source>NIfTI header is damaged</source>
        <translation>NIfTI ヘッダーが壊れています</translation>
    </message>
    <message>
        <source>holds %1 dimensions</source>
        <translation>%1 次元あります</translation>
    </message>
    <message>
        <source>%1one 3-D volume was expected</source>
        <translation>%1 3-D ボリューム 1 つが必要です</translation>
    </message>
    <message>
        <source>extract the T1 volume first</source>
        <translation>先に T1 のボリュームを取り出してください</translation>
    </message>
    <message>
        <source>choose a file of vectors</source>
        <translation>ベクトルのファイルを選んでください</translation>
    </message>
    <message>
        <source>voxel type %1 is not a scalar</source>
        <translation>ボクセルの型 %1 はスカラーではありません</translation>
    </message>
    <message>
        <source>export the T1 as a grey-value volume</source>
        <translation>T1 をグレー値のボリュームとして書き出してください</translation>
    </message>
    <message>
        <source>holds the value %1: no grey value of a scan</source>
        <translation>値 %1 があります: スキャンのグレー値ではありません</translation>
    </message>
    <message>
        <source>check the slope in its header (scl_slope), or export it again</source>
        <translation>ヘッダーの傾き (scl_slope) を確認するか、書き出し直してください</translation>
    </message>
    <message>
        <source>not enough memory for a NIfTI volume</source>
        <translation>NIfTI ボリュームにはメモリーが足りません</translation>
    </message>
    <message>
        <source>name must end in .nii or .nii.gz</source>
        <translation>名前の末尾は .nii または .nii.gz でなければなりません</translation>
    </message>
    <message>
        <source>no such NIfTI transform: %1</source>
        <translation>その NIfTI 変換はありません: %1</translation>
    </message>
    <message>
        <source>one of automatic, sform, qform</source>
        <translation>automatic、sform、qform のいずれかです</translation>
    </message>
    <message>
        <source>holds no 3-D volume</source>
        <translation>3-D ボリュームがありません</translation>
    </message>
    <message>
        <source>choose the T1</source>
        <translation>T1 を選んでください</translation>
    </message>
    <message>
        <source>orientation matrix is singular</source>
        <translation>向きの行列が特異です</translation>
    </message>
    <message>
        <source>export the volume again</source>
        <translation>ボリュームを書き出し直してください</translation>
    </message>
    <message>
        <source>the voxel axes of its %1 are sheared by %2 degrees; those of its %3 are at right angles</source>
        <translation>%1 のボクセル軸が %2 度歪んでいます。%3 の軸は直交しています</translation>
    </message>
    <message>
        <source>the voxel axes of its %1 are sheared by %2 degrees</source>
        <translation>%1 のボクセル軸が %2 度歪んでいます</translation>
    </message>
    <message>
        <source>take the %1 (--nifti-transform %2), and compare left and right with the person</source>
        <translation>%1 を使い (--nifti-transform %2)、左右を本人と比べてください</translation>
    </message>
    <message>
        <source>resample the volume onto an orthogonal grid</source>
        <translation>ボリュームを直交格子に再サンプリングしてください</translation>
    </message>
    <message>
        <source>its voxels would be %1 x %2 x %3 mm: its header names no unit of length</source>
        <translation>ボクセルが %1 x %2 x %3 mm になります: ヘッダーに長さの単位がありません</translation>
    </message>
    <message>
        <source>its voxels would be %1 x %2 x %3 mm: its header names no unit of length, its values look like %4</source>
        <translation>ボクセルが %1 x %2 x %3 mm になります: ヘッダーに長さの単位がなく、値は %4 のようです</translation>
    </message>
    <message>
        <source>its voxels would be %1 x %2 x %3 mm: the unit in its header is %4</source>
        <translation>ボクセルが %1 x %2 x %3 mm になります: ヘッダーの単位は %4 です</translation>
    </message>
    <message>
        <source>its voxels would be %1 x %2 x %3 mm: the unit in its header is %4, its values look like %5</source>
        <translation>ボクセルが %1 x %2 x %3 mm になります: ヘッダーの単位は %4 ですが、値は %5 のようです</translation>
    </message>
    <message>
        <source>correct the unit in the header (xyzt_units), or export it again from DICOM</source>
        <translation>ヘッダーの単位 (xyzt_units) を直すか、DICOM から書き出し直してください</translation>
    </message>
    <message>
        <source>aligned to another scan</source>
        <translation>別のスキャンに合わせてあります</translation>
    </message>
    <message>
        <source>sform and qform are mirror images: they disagree about left and right</source>
        <translation>sform と qform が互いに鏡像です: 左右が食い違っています</translation>
    </message>
    <message>
        <source>sform and qform disagree about the size of the head by %1 %</source>
        <translation>sform と qform で頭の大きさが %1 % 食い違っています</translation>
    </message>
    <message>
        <source>has neither sform nor qform, so left and right are not known</source>
        <translation>sform も qform もなく、左右が分かりません</translation>
    </message>
    <message>
        <source>export it again from DICOM, e.g. with dcm2niix</source>
        <translation>dcm2niix などで DICOM から書き出し直してください</translation>
    </message>
    <message>
        <source>has no %1</source>
        <translation>%1 がありません</translation>
    </message>
    <message>
        <source>choose the qform</source>
        <translation>qform を選んでください</translation>
    </message>
    <message>
        <source>choose the sform</source>
        <translation>sform を選んでください</translation>
    </message>
    <message>
        <source>%1 (%2), as asked for</source>
        <translation>指定どおり %1 (%2)</translation>
    </message>
    <message>
        <source>the %1 agrees</source>
        <translation>%1 も一致しています</translation>
    </message>
    <message>
        <source>the %1 (%2) lies up to %3 off</source>
        <translation>%1 (%2) は最大 %3 ずれています</translation>
    </message>
    <message>
        <source>sform and qform disagree by up to %1; the %2 is used</source>
        <translation>sform と qform が最大 %1 食い違っています。%2 を使います</translation>
    </message>
    <message>
        <source>%1; the %2 is used</source>
        <translation>%1。%2 を使います</translation>
    </message>
    <message>
        <source>find out which one is right before this case is used (--nifti-transform qform takes the other)</source>
        <translation>この症例を使う前に、どちらが正しいか確認してください (--nifti-transform qform で他方を使います)</translation>
    </message>
    <message>
        <source>the mask is empty</source>
        <translation>マスクが空です</translation>
    </message>
    <message>
        <source>the volume holds no finite voxel</source>
        <translation>ボリュームに有限のボクセルがありません</translation>
    </message>
    <message>
        <source>masks lie on different grids</source>
        <translation>マスクの格子が異なります</translation>
    </message>
    <message>
        <source>resample one onto the other first</source>
        <translation>先に一方を他方に合わせて再サンプリングしてください</translation>
    </message>
    <message>
        <source>the cortex point of &apos;%1&apos; lies outside the MRI</source>
        <translation>&apos;%1&apos; の皮質上の点が MRI の外にあります</translation>
    </message>
    <message>
        <source>FaceNav plan - NOT FOR DIAGNOSIS</source>
        <translation>FaceNav plan - NOT FOR DIAGNOSIS</translation>
    </message>
    <message>
        <source>coil of %1</source>
        <translation>%1 のコイル</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>患者の右側</translation>
    </message>
    <message>
        <source>left side</source>
        <translation>患者の左側</translation>
    </message>
    <message>
        <source>inside -%1 mm      outside +%2 mm    grey: not counted</source>
        <translation>内側 -%1 mm      外側 +%2 mm    灰色: 対象外</translation>
    </message>
    <message>
        <source>from above (right on the right)</source>
        <translation>上から (患者の右が図の右)</translation>
    </message>
    <message>
        <source>front (right on the left)</source>
        <translation>前から (患者の右が図の左)</translation>
    </message>
    <message>
        <source>back (right on the right)</source>
        <translation>後ろから (患者の右が図の右)</translation>
    </message>
    <message>
        <source>from below (right on the left)</source>
        <translation>下から (患者の右が図の左)</translation>
    </message>
    <message>
        <source>within the phi-theta surface</source>
        <translation>φ–θ 面の内側</translation>
    </message>
    <message>
        <source>outside it</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>%1: median %2 mm, 95 % below %3 mm</source>
        <translation>%1: 中央値 %2 mm、95 % が %3 mm 未満</translation>
    </message>
    <message>
        <source>cortex (folds included) to the phi-theta surface</source>
        <translation>皮質 (溝を含む) から φ–θ 面まで</translation>
    </message>
    <message>
        <source>phi-theta surface to the cortex</source>
        <translation>φ–θ 面から皮質まで</translation>
    </message>
    <message>
        <source>error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>横ずれ</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深さ</translation>
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
        <source>gap</source>
        <translation>隙間</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % の範囲</translation>
    </message>
    <message>
        <source>output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>潜時</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>field at 1 A/us</source>
        <translation>1 A/us での電場</translation>
    </message>
    <message>
        <source>largest field</source>
        <translation>最大電場</translation>
    </message>
    <message>
        <source>largest at 1 A/us</source>
        <translation>1 A/us での最大</translation>
    </message>
    <message>
        <source>%1 (last bar: and more)</source>
        <translation>%1 (最後の棒: それ以上)</translation>
    </message>
    <message>
        <source>Pulses by %1</source>
        <translation>%1 別のパルス</translation>
    </message>
    <message>
        <source>no pulse has: %1</source>
        <translation>この値を持つパルスなし: %1</translation>
    </message>
    <message>
        <source>mm, seen from above, handle below; dashed: %1 mm</source>
        <translation>mm、上から見た図、ハンドルは下。破線: %1 mm</translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation>%1 の時間変化</translation>
    </message>
    <message>
        <source>minutes since the first pulse</source>
        <translation>最初のパルスからの分</translation>
    </message>
    <message>
        <source>the pain is given as 0 to 10</source>
        <translation>痛みは 0〜10 で入力してください</translation>
    </message>
    <message>
        <source>0: none, 10: the worst imaginable</source>
        <translation>0: なし、10: 想像しうる最悪の痛み</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>何も入力されていません</translation>
    </message>
    <message>
        <source>describe it in some words</source>
        <translation>短い言葉で入力してください</translation>
    </message>
    <message>
        <source>face found</source>
        <translation>顔を検出</translation>
    </message>
    <message>
        <source>cameras back</source>
        <translation>カメラ復帰</translation>
    </message>
    <message>
        <source>not ended: it still runs, or it was cut off</source>
        <translation>終了していません: 実行中か、途中で切れています</translation>
    </message>
    <message>
        <source>stopped by a fault: %1</source>
        <translation>異常により停止: %1</translation>
    </message>
    <message>
        <source>ended, but not by the operator: %1</source>
        <translation>操作者によらずに終了: %1</translation>
    </message>
    <message>
        <source>ended normally</source>
        <translation>正常に終了</translation>
    </message>
    <message>
        <source>face lost</source>
        <translation>顔の追跡喪失</translation>
    </message>
    <message>
        <source>coil lost</source>
        <translation>コイルの追跡喪失</translation>
    </message>
    <message>
        <source>adverse event</source>
        <translation>有害事象</translation>
    </message>
    <message>
        <source>double trigger</source>
        <translation>二重トリガー</translation>
    </message>
    <message>
        <source>at home</source>
        <translation>在宅</translation>
    </message>
    <message>
        <source>the coil&apos;s mesh is missing</source>
        <translation>コイルのメッシュがありません</translation>
    </message>
    <message>
        <source>see &quot;mesh&quot; in coil.json</source>
        <translation>coil.json の &quot;mesh&quot; を参照してください</translation>
    </message>
    <message>
        <source>no triangles in the coil&apos;s mesh</source>
        <translation>コイルのメッシュに三角形がありません</translation>
    </message>
    <message>
        <source>export it as STL</source>
        <translation>STL で書き出してください</translation>
    </message>
    <message>
        <source>sampling below the surface</source>
        <translation>表面下を標本化しています</translation>
    </message>
    <message>
        <source>this display offers no OpenGL 3.2 (a remote desktop, or an old graphics driver)</source>
        <translation>この画面では OpenGL 3.2 を使えません (リモートデスクトップ、または古いグラフィックドライバー)</translation>
    </message>
    <message>
        <source>no picture can be drawn: %1</source>
        <translation>図を描けません: %1</translation>
    </message>
    <message>
        <source>unset DISPLAY, or use another display</source>
        <translation>DISPLAY の設定を外すか、別の画面を使ってください</translation>
    </message>
    <message>
        <source>the picture is empty</source>
        <translation>画像が空です</translation>
    </message>
    <message>
        <source>the pair with dots</source>
        <translation>ドットありの組</translation>
    </message>
    <message>
        <source>the plain pair</source>
        <translation>ドットなしの組</translation>
    </message>
    <message>
        <source>the film</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>not aligned: the recording has no film</source>
        <translation>位置合わせできません: 記録に動画がありません</translation>
    </message>
    <message>
        <source>not aligned: the recording has no capture/ pair</source>
        <translation>位置合わせできません: 記録に capture/ の組がありません</translation>
    </message>
    <message>
        <source>choose another way (dots, plain, film), or record one</source>
        <translation>別の方法 (dots、plain、film) を選ぶか、撮影してください</translation>
    </message>
    <message>
        <source>not aligned: without dots the face alone does not show whether a camera has turned sideways since the calibration</source>
        <translation>位置合わせできません: ドットがないと、較正後にカメラが横に回ったかどうかを顔だけからは判定できません</translation>
    </message>
    <message>
        <source>the coil could lie %1 mm from where it is shown</source>
        <translation>コイルが表示より %1 mm ずれている可能性があります</translation>
    </message>
    <message>
        <source>hold the coil still beside the face, its marker to both cameras, and take the pictures again</source>
        <translation>コイルを顔の横に静止させ、マーカーを両方のカメラに向けて、撮影し直してください</translation>
    </message>
    <message>
        <source>(or switch the projector on: its picture shows no dots)</source>
        <translation>(またはプロジェクターを点けてください: 画像にドットがありません)</translation>
    </message>
    <message>
        <source>(or with a projector&apos;s dots)</source>
        <translation>(またはプロジェクターのドットを使ってください)</translation>
    </message>
    <message>
        <source>with and without dots the head lies %1 mm apart: check that it did not move in between, and take the pictures again</source>
        <translation>ドットありとなしで頭の位置が %1 mm 異なります: 間に動いていないか確認し、撮影し直してください</translation>
    </message>
    <message>
        <source>%1 was refused (%2)</source>
        <translation>%1は使えませんでした (%2)</translation>
    </message>
    <message>
        <source>%1 would give 95 % within %2 mm</source>
        <translation>%1なら 95 % が %2 mm 以内になります</translation>
    </message>
    <message>
        <source>this is the patient&apos;s own MRI</source>
        <translation>これは患者本人の MRI です</translation>
    </message>
    <message>
        <source>this scan</source>
        <translation>このスキャン</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>this is</source>
        <translation>これは</translation>
    </message>
    <message>
        <source>this is the person whose face is stored</source>
        <translation>これは保存された顔の本人です</translation>
    </message>
    <message>
        <source>the stored face</source>
        <translation>保存された顔</translation>
    </message>
    <message>
        <source>not aligned: the recording has no pictures of the face</source>
        <translation>位置合わせできません: 記録に顔の画像がありません</translation>
    </message>
    <message>
        <source>record a still pair (facenav record --capture) or a film of the face</source>
        <translation>静止画の組 (facenav record --capture) または顔の動画を撮影してください</translation>
    </message>
    <message>
        <source>used %1: 95 % within %2 mm</source>
        <translation>%1を使用: 95 % が %2 mm 以内</translation>
    </message>
    <message>
        <source>not aligned: this scan holds no face to align to</source>
        <translation>位置合わせできません: このスキャンに位置合わせに使う顔がありません</translation>
    </message>
    <message>
        <source>use a scan of the whole head</source>
        <translation>頭部全体のスキャンを使ってください</translation>
    </message>
    <message>
        <source>nothing excludes that a camera turned sideways since the calibration: then the coil lies up to %1 mm from where it is shown</source>
        <translation>較正後にカメラが横に回っていないとは言えません: 回っていた場合、コイルは表示より最大 %1 mm ずれています</translation>
    </message>
    <message>
        <source>%1; %2, and align again</source>
        <translation>%1。%2。その後、位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>%1. Hold the coil still beside the face, its marker to both cameras, while the picture without dots is taken, and align again</source>
        <translation>%1。ドットなしの撮影の間、コイルを顔の横に静止させ、マーカーを両方のカメラに向けて、位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>the images disagree with the calibration by %1 px across the rows: the cameras may have moved since; check them with the board, or calibrate again</source>
        <translation>画像が較正と行方向に直交して %1 px ずれています: その後カメラが動いた可能性があります。ボードで点検するか、較正し直してください</translation>
    </message>
    <message>
        <source>the skin at %1 is unsure by %2 mm (pads or haze in the scan): check the coil&apos;s gap there</source>
        <translation>%1 の皮膚の不確かさは %2 mm です (スキャンのパッドやもや): そこでのコイルの隙間を確認してください</translation>
    </message>
    <message>
        <source>not aligned: the head moved by %1 mm and %2 deg between the picture with dots and the one without</source>
        <translation>位置合わせできません: ドットありの撮影となしの撮影の間に、頭が %1 mm、%2 deg 動きました</translation>
    </message>
    <message>
        <source>hold the head still and take both pictures again</source>
        <translation>頭を動かさずに、両方とも撮影し直してください</translation>
    </message>
    <message>
        <source>finding the face</source>
        <translation>顔を探しています</translation>
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
        <source>nose tip</source>
        <translation>鼻尖</translation>
    </message>
    <message>
        <source>judged right: %1; tip at (%2, %3, %4) mm in the MRI</source>
        <translation>一致と判定: %1; 先端は MRI の (%2, %3, %4) mm</translation>
    </message>
    <message>
        <source>judged right: %1; picked spot at (%2, %3, %4) mm in the MRI</source>
        <translation>一致と判定: %1; 選んだ点は MRI の (%2, %3, %4) mm</translation>
    </message>
    <message>
        <source>judged wrong: %1; tip at (%2, %3, %4) mm in the MRI</source>
        <translation>不一致と判定: %1; 先端は MRI の (%2, %3, %4) mm</translation>
    </message>
    <message>
        <source>judged wrong: %1; picked spot at (%2, %3, %4) mm in the MRI</source>
        <translation>不一致と判定: %1; 選んだ点は MRI の (%2, %3, %4) mm</translation>
    </message>
    <message>
        <source>picked spot</source>
        <translation>選んだ点</translation>
    </message>
    <message>
        <source>the picture is taken</source>
        <translation>撮影しています</translation>
    </message>
    <message>
        <source>hold the coil beside the face, its marker to both cameras</source>
        <translation>コイルを顔の横に持ち、マーカーを両方のカメラに向けてください</translation>
    </message>
    <message>
        <source>hold the coil still</source>
        <translation>コイルを動かさないでください</translation>
    </message>
    <message>
        <source>hold the head still: the cameras do not expose at the same time</source>
        <translation>頭を動かさないでください: カメラの露光が同時ではありません</translation>
    </message>
    <message>
        <source>both cameras must see the whole face: look at them, nothing before the face</source>
        <translation>両方のカメラから顔全体が見えなければなりません: カメラを見て、顔の前のものをどけてください</translation>
    </message>
    <message>
        <source>no picture was taken: %1</source>
        <translation>撮影できませんでした: %1</translation>
    </message>
    <message>
        <source>no picture was taken before the cameras ended: %1</source>
        <translation>カメラが終了するまでに撮影できませんでした: %1</translation>
    </message>
    <message>
        <source>%1the capture&apos;s picture for the dots shows none, or too few (switch the projector on); without them: %2</source>
        <translation>%1ドット用の画像にドットがないか、少なすぎます (プロジェクターを点けてください)。ドットなし: %2</translation>
    </message>
    <message>
        <source>%1the capture&apos;s picture for the dots shows none, or too few (switch the projector on: the matcher &apos;%2&apos; needs them); without them: %3</source>
        <translation>%1ドット用の画像にドットがないか、少なすぎます (プロジェクターを点けてください: 照合方式 &apos;%2&apos; に必要です)。ドットなし: %3</translation>
    </message>
    <message>
        <source>no face was found in both pictures</source>
        <translation>両方の画像で顔が見つかりませんでした</translation>
    </message>
    <message>
        <source>look at the cameras, the whole face lit and in view of both</source>
        <translation>カメラを見て、明るい顔全体が両方のカメラに写るようにしてください</translation>
    </message>
    <message>
        <source>the coil&apos;s marker measures %1 +/- %2 % of its printed size: a camera has turned sideways since the calibration, or the print has another size</source>
        <translation>コイルのマーカーの計測値が印刷時の大きさの %1 +/- %2 % です: 較正後にカメラが横に回ったか、印刷物の大きさが異なります</translation>
    </message>
    <message>
        <source>check the cameras (&apos;facenav rig check&apos;) and the size of the print</source>
        <translation>カメラ (&apos;facenav rig check&apos;) と印刷物の大きさを確認してください</translation>
    </message>
    <message>
        <source>the face may have been measured by %1 % too large or too small</source>
        <translation>顔の計測が %1 % 大きすぎるか小さすぎる可能性があります</translation>
    </message>
    <message>
        <source>the face may have been measured too large or too small</source>
        <translation>顔の計測が大きすぎるか小さすぎる可能性があります</translation>
    </message>
    <message>
        <source>%1nothing showed well enough whether a camera had turned sideways since the calibration</source>
        <translation>%1較正後にカメラが横に回ったかどうかを、十分に示すものがありませんでした</translation>
    </message>
    <message>
        <source>hold the coil still beside the face, its marker to both cameras, and take the pictures again (or use a projector&apos;s dots)</source>
        <translation>コイルを顔の横に静止させ、マーカーを両方のカメラに向けて、撮影し直してください (またはプロジェクターのドットを使ってください)</translation>
    </message>
    <message>
        <source>the capture&apos;s picture for the dots shows none</source>
        <translation>ドット用の画像にドットがありません</translation>
    </message>
    <message>
        <source>switch the projector on and take the pictures again</source>
        <translation>プロジェクターを点けて、撮影し直してください</translation>
    </message>
    <message>
        <source>the face of the last alignment was not kept</source>
        <translation>前回の位置合わせの顔が保存されていません</translation>
    </message>
    <message>
        <source>align the case again</source>
        <translation>症例の位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>without a projector</source>
        <translation>プロジェクターなし</translation>
    </message>
    <message>
        <source>in a film</source>
        <translation>動画で</translation>
    </message>
    <message>
        <source>its size to %1 %</source>
        <translation>大きさ %1 % まで</translation>
    </message>
    <message>
        <source>its size not compared with a marker</source>
        <translation>大きさはマーカーと比較していません</translation>
    </message>
    <message>
        <source>no MRI: the face measured%1 in %2 points (%3 mm each, %4 mm as a whole%5) stands in for it; places and errors are relative to that visit</source>
        <translation>MRI なし: %2 点で計測した顔%1 (各 %3 mm、全体で %4 mm%5) を代わりに使います。位置と誤差はその来院時を基準とします</translation>
    </message>
    <message>
        <source>the case was aligned with another camera rig than this recording&apos;s</source>
        <translation>症例の位置合わせは、この記録とは別のカメラ構成で行われています</translation>
    </message>
    <message>
        <source>align again with a capture of this rig</source>
        <translation>このカメラ構成で撮影し、位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>the recording has no film</source>
        <translation>記録に動画がありません</translation>
    </message>
    <message>
        <source>the recording has no capture/ pair</source>
        <translation>記録に capture/ の組がありません</translation>
    </message>
    <message>
        <source>the recording has no pictures of the face</source>
        <translation>記録に顔の画像がありません</translation>
    </message>
    <message>
        <source>A camera is gone: plug it in again, and wait</source>
        <translation>カメラが外れました: 接続し直して、待ってください</translation>
    </message>
    <message>
        <source>The cameras were moved: stop, and call the clinic</source>
        <translation>カメラが動きました: 中止して、病院に電話してください</translation>
    </message>
    <message>
        <source>The two cameras do not work together: stop, and call the clinic</source>
        <translation>2 台のカメラがそろって動作していません: 中止して、病院に電話してください</translation>
    </message>
    <message>
        <source>The face no longer fits its first measurement: finish, and start again</source>
        <translation>顔が最初の計測と合わなくなりました: 終了して、もう一度始めてください</translation>
    </message>
    <message>
        <source>This is not the person whose face is stored: stop</source>
        <translation>保存された顔の本人ではありません: 中止してください</translation>
    </message>
    <message>
        <source>Your face is hidden: move hand and coil aside</source>
        <translation>顔が隠れています: 手とコイルをどけてください</translation>
    </message>
    <message>
        <source>You sit too far away: come nearer to the cameras</source>
        <translation>カメラから遠すぎます: 近づいてください</translation>
    </message>
    <message>
        <source>A camera gives no picture: check its cable</source>
        <translation>カメラの画像が来ません: ケーブルを確認してください</translation>
    </message>
    <message>
        <source>Sit still and look at the cameras: your face is not seen</source>
        <translation>静かに座ってカメラを見てください: 顔が見えません</translation>
    </message>
    <message>
        <source>its left side</source>
        <translation>コイルの左側</translation>
    </message>
    <message>
        <source>its right side</source>
        <translation>コイルの右側</translation>
    </message>
    <message>
        <source>the handle</source>
        <translation>ハンドル</translation>
    </message>
    <message>
        <source>its front, away from the handle</source>
        <translation>ハンドルと反対の前側</translation>
    </message>
    <message>
        <source>Good: hold the coil still</source>
        <translation>よい位置です: コイルを動かさないでください</translation>
    </message>
    <message>
        <source>Slide the coil along the head, as the arrow points: %1</source>
        <translation>矢印の方向へ、コイルを頭に沿って滑らせてください: %1</translation>
    </message>
    <message>
        <source>Lift the coil a little: %1</source>
        <translation>コイルを少し離してください: %1</translation>
    </message>
    <message>
        <source>Bring the coil closer to the head: %1</source>
        <translation>コイルを頭に近づけてください: %1</translation>
    </message>
    <message>
        <source>Tilt the coil: raise %1, %2</source>
        <translation>コイルを傾けてください: %1を上げる、%2</translation>
    </message>
    <message>
        <source>Turn the coil like a key, to the left: %1</source>
        <translation>鍵を回すようにコイルを左へ回してください: %1</translation>
    </message>
    <message>
        <source>Turn the coil like a key, to the right: %1</source>
        <translation>鍵を回すようにコイルを右へ回してください: %1</translation>
    </message>
    <message>
        <source>The program stopped: finish, and call the clinic</source>
        <translation>プログラムが停止しました: 終了して、病院に電話してください</translation>
    </message>
    <message>
        <source>This is not the coil of the treatment: take the right one</source>
        <translation>治療用のコイルではありません: 正しいコイルを持ってください</translation>
    </message>
    <message>
        <source>Hold the coil so that its printed marker faces the cameras</source>
        <translation>印刷されたマーカーがカメラを向くようにコイルを持ってください</translation>
    </message>
    <message>
        <source>Wait a moment</source>
        <translation>お待ちください</translation>
    </message>
    <message>
        <source>the stored face was measured without</source>
        <translation>the stored face was measured without</translation>
    </message>
    <message>
        <source>The clinic measured this face without the coil&apos;s marker: switch the projector on, or ask the clinic for a new file</source>
        <translation>病院では、この顔をコイルのマーカーなしで計測しました: プロジェクターを点けるか、新しいファイルを病院に依頼してください</translation>
    </message>
    <message>
        <source>no picture was taken</source>
        <translation>撮影できませんでした</translation>
    </message>
    <message>
        <source>the face alone does not show</source>
        <translation>the face alone does not show</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>does not fit</translation>
    </message>
    <message>
        <source>Hold the coil still beside the face, its printed marker to both cameras, and try again</source>
        <translation>コイルを顔の横に静止させ、印刷されたマーカーを両方のカメラに向けて、もう一度試してください</translation>
    </message>
    <message>
        <source>This face is not the stored one: only that person can be treated</source>
        <translation>保存された顔と違います: 治療できるのは本人だけです</translation>
    </message>
    <message>
        <source>shows none</source>
        <translation>shows none</translation>
    </message>
    <message>
        <source>no dots</source>
        <translation>no dots</translation>
    </message>
    <message>
        <source>The dots are not seen on the face: switch the projector on, and try again</source>
        <translation>顔にドットが見えません: プロジェクターを点けて、もう一度試してください</translation>
    </message>
    <message>
        <source>too little</source>
        <translation>too little</translation>
    </message>
    <message>
        <source>nothing like a face</source>
        <translation>nothing like a face</translation>
    </message>
    <message>
        <source>no face</source>
        <translation>no face</translation>
    </message>
    <message>
        <source>no point of a face</source>
        <translation>no point of a face</translation>
    </message>
    <message>
        <source>Too little of the face is seen: move hair and hands aside, look at the cameras, and try again</source>
        <translation>顔の見える範囲が足りません: 髪と手をどけてカメラを見て、もう一度試してください</translation>
    </message>
    <message>
        <source>The cameras were moved or changed: do not treat, and call the clinic</source>
        <translation>カメラが動いたか、変わっています: 治療せずに、病院に電話してください</translation>
    </message>
    <message>
        <source>facenav home case</source>
        <translation>facenav home case</translation>
    </message>
    <message>
        <source>the case has several expert&apos;s poses</source>
        <translation>症例に専門家の姿勢が複数あります</translation>
    </message>
    <message>
        <source>choose one: %1, &apos;%2&apos;</source>
        <translation>1 つ選んでください: %1、&apos;%2&apos;</translation>
    </message>
    <message>
        <source>the case has no expert&apos;s pose</source>
        <translation>症例に専門家の姿勢がありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no expert&apos;s pose</source>
        <translation>&apos;%1&apos; は専門家の姿勢ではありません</translation>
    </message>
    <message>
        <source>store one with &apos;facenav target CASE --from-session&apos;</source>
        <translation>&apos;facenav target CASE --from-session&apos; で保存してください</translation>
    </message>
    <message>
        <source>the expert&apos;s coil &apos;%1&apos; is not in the library</source>
        <translation>専門家のコイル &apos;%1&apos; がライブラリにありません</translation>
    </message>
    <message>
        <source>give its coil.json with --coil</source>
        <translation>--coil でその coil.json を指定してください</translation>
    </message>
    <message>
        <source>the expert held the coil &apos;%1&apos;, this is &apos;%2&apos;</source>
        <translation>専門家のコイルは &apos;%1&apos; ですが、これは &apos;%2&apos; です</translation>
    </message>
    <message>
        <source>use the expert&apos;s coil, or store the pose again with this one</source>
        <translation>専門家のコイルを使うか、このコイルで姿勢を保存し直してください</translation>
    </message>
    <message>
        <source>the case was aligned again since the expert&apos;s session %1</source>
        <translation>専門家のセッション %1 の後に、症例の位置合わせがやり直されています</translation>
    </message>
    <message>
        <source>export before the next visit, or store the expert&apos;s pose of a session of the last alignment</source>
        <translation>次の来院の前に書き出すか、最後の位置合わせのセッションから専門家の姿勢を保存してください</translation>
    </message>
    <message>
        <source>the case was never aligned, so no face was measured</source>
        <translation>症例の位置合わせが一度も行われておらず、顔が計測されていません</translation>
    </message>
    <message>
        <source>align it with a recording first</source>
        <translation>先に記録を使って位置合わせを行ってください</translation>
    </message>
    <message>
        <source>the pictures of the alignment are missing</source>
        <translation>位置合わせの画像がありません</translation>
    </message>
    <message>
        <source>align again</source>
        <translation>位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>the visit at which the face was measured</source>
        <translation>顔を計測した来院</translation>
    </message>
    <message>
        <source>is no home case of FaceNav</source>
        <translation>FaceNav の在宅用症例ではありません</translation>
    </message>
    <message>
        <source>choose the file that the clinic gave</source>
        <translation>病院から渡されたファイルを選んでください</translation>
    </message>
    <message>
        <source>the home case is of another version of FaceNav</source>
        <translation>在宅用症例が FaceNav の別のバージョンのものです</translation>
    </message>
    <message>
        <source>is no time</source>
        <translation>時刻ではありません</translation>
    </message>
    <message>
        <source>it was made on %1, the case that is there already on %2</source>
        <translation>作成日は %1、既にある症例は %2 です</translation>
    </message>
    <message>
        <source>choose the newest file of the clinic</source>
        <translation>病院の最も新しいファイルを選んでください</translation>
    </message>
    <message>
        <source>another case is there already</source>
        <translation>既に別の症例があります</translation>
    </message>
    <message>
        <source>this is the case with the MRI that the file was made of</source>
        <translation>これは、ファイルの元になった MRI のある症例です</translation>
    </message>
    <message>
        <source>holds a folder &apos;%1&apos; that was not expected</source>
        <translation>予期しないフォルダー &apos;%1&apos; があります</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it has changed since it was made</source>
        <translation>作成後に、中の &apos;%1&apos; が変わっています</translation>
    </message>
    <message>
        <source>ask the clinic for the file again</source>
        <translation>病院にもう一度ファイルを依頼してください</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in it</source>
        <translation>中に &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>the case holds no face to know the person by</source>
        <translation>症例に本人を見分けるための顔がありません</translation>
    </message>
    <message>
        <source>the case names no coil</source>
        <translation>症例にコイルの指定がありません</translation>
    </message>
    <message>
        <source>facenav session</source>
        <translation>facenav session</translation>
    </message>
    <message>
        <source>ask for the file again</source>
        <translation>もう一度ファイルを依頼してください</translation>
    </message>
    <message>
        <source>is no session that FaceNav sent back</source>
        <translation>FaceNav が返送したセッションではありません</translation>
    </message>
    <message>
        <source>choose the file that was saved at home</source>
        <translation>在宅で保存したファイルを選んでください</translation>
    </message>
    <message>
        <source>is no session of FaceNav</source>
        <translation>FaceNav のセッションではありません</translation>
    </message>
    <message>
        <source>the session is of another version of FaceNav</source>
        <translation>セッションが FaceNav の別のバージョンのものです</translation>
    </message>
    <message>
        <source>is no name of a session</source>
        <translation>セッションの名前ではありません</translation>
    </message>
    <message>
        <source>is of another case (%1), this one is %2</source>
        <translation>別の症例 (%1) のものです。これは %2 です</translation>
    </message>
    <message>
        <source>none is named</source>
        <translation>指定がありません</translation>
    </message>
    <message>
        <source>choose that case; nothing was imported</source>
        <translation>その症例を選んでください。何も取り込まれていません</translation>
    </message>
    <message>
        <source>facenav returned session</source>
        <translation>facenav returned session</translation>
    </message>
    <message>
        <source>holds %1 pulses, its summary says %2</source>
        <translation>パルスは %1 回ですが、要約では %2 回です</translation>
    </message>
    <message>
        <source>is at odds with an earlier file of the session %1</source>
        <translation>セッション %1 の以前のファイルと食い違っています</translation>
    </message>
    <message>
        <source>keep both files and ask where they come from; nothing was imported</source>
        <translation>両方のファイルを残し、出どころを確認してください。何も取り込まれていません</translation>
    </message>
    <message>
        <source>added to the case</source>
        <translation>症例に加えました</translation>
    </message>
    <message>
        <source>was here already; what was noted later is added</source>
        <translation>既にありました。後から記録された分を加えました</translation>
    </message>
    <message>
        <source>was here already, nothing changed</source>
        <translation>既にありました。変更はありません</translation>
    </message>
    <message>
        <source>session %1 (at home), %2 pulses: %3</source>
        <translation>セッション %1 (在宅)、パルス %2 回: %3</translation>
    </message>
    <message>
        <source>the place lies %1 mm from the skin</source>
        <translation>その場所は皮膚から %1 mm 離れています</translation>
    </message>
    <message>
        <source>choose a place on the skin</source>
        <translation>皮膚の上の場所を選んでください</translation>
    </message>
    <message>
        <source>ring: 95 % within %1 mm</source>
        <translation>輪: 95 % が %1 mm 以内</translation>
    </message>
    <message>
        <source>%1: along the handle (on the left), cortex %2 mm below the scalp</source>
        <translation>%1: ハンドル方向 (ハンドルは左)、皮質は頭皮下 %2 mm</translation>
    </message>
    <message>
        <source>across the handle, as seen from it; a tick is 10 mm%1</source>
        <translation>ハンドル横断方向 (ハンドル側から見た図)。目盛りは 10 mm%1</translation>
    </message>
    <message>
        <source>the case has no brain mask, so the field in the brain is not known</source>
        <translation>症例に脳マスクがないため、脳内の電場は分かりません</translation>
    </message>
    <message>
        <source>write the field on the cortex (.vtp, .msh)</source>
        <translation>皮質上の電場 (.vtp、.msh) を書き出してください</translation>
    </message>
    <message>
        <source>the coil gives no field at the target</source>
        <translation>コイルの電場が標的にありません</translation>
    </message>
    <message>
        <source>check its pose</source>
        <translation>姿勢を確認してください</translation>
    </message>
    <message>
        <source>pulse %1 is excluded (%2)</source>
        <translation>パルス %1 は除外されています (%2)</translation>
    </message>
    <message>
        <source>pulse %1 has no pose: %2</source>
        <translation>パルス %1 には姿勢がありません: %2</translation>
    </message>
    <message>
        <source>choose another pulse</source>
        <translation>別のパルスを選んでください</translation>
    </message>
    <message>
        <source>it has %1 pulses</source>
        <translation>パルスは %1 回です</translation>
    </message>
    <message>
        <source>the session has no pulse on target &apos;%1&apos;</source>
        <translation>セッションに標的 &apos;%1&apos; 上のパルスがありません</translation>
    </message>
    <message>
        <source>the session has no pulse on target%1</source>
        <translation>セッションに標的上のパルスがありません%1</translation>
    </message>
    <message>
        <source>choose one pulse with --pulse N, or another session</source>
        <translation>--pulse N でパルスを 1 つ選ぶか、別のセッションを使ってください</translation>
    </message>
    <message>
        <source>the pulses are of two coils, &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>パルスが 2 つのコイル &apos;%1&apos; と &apos;%2&apos; のものです</translation>
    </message>
    <message>
        <source>choose one pulse with --pulse N</source>
        <translation>--pulse N でパルスを 1 つ選んでください</translation>
    </message>
    <message>
        <source>the pulses lie %1 mm and %2 deg round their median: they are not one pose</source>
        <translation>パルスの中央値からのばらつきが %1 mm、%2 deg です: 1 つの姿勢ではありません</translation>
    </message>
    <message>
        <source>choose one pulse with --pulse N, or exclude those that slipped</source>
        <translation>--pulse N でパルスを 1 つ選ぶか、ずれたパルスを除外してください</translation>
    </message>
    <message>
        <source>the target &apos;%1&apos; is locked</source>
        <translation>標的 &apos;%1&apos; はロックされています</translation>
    </message>
    <message>
        <source>unlock it first, or give another --name</source>
        <translation>先にロックを解除するか、別の --name を指定してください</translation>
    </message>
    <message>
        <source>pulse %1 lay outside the tolerance</source>
        <translation>パルス %1 は許容範囲外でした</translation>
    </message>
    <message>
        <source>the expert held the coil &apos;%1&apos; there, this is &apos;%2&apos;</source>
        <translation>そこでの専門家のコイルは &apos;%1&apos; ですが、これは &apos;%2&apos; です</translation>
    </message>
    <message>
        <source>one pulse</source>
        <translation>1 パルス</translation>
    </message>
    <message>
        <source>median of %1 pulses</source>
        <translation>%1 パルスの中央値</translation>
    </message>
    <message>
        <source>of session %1</source>
        <translation>セッション %1</translation>
    </message>
    <message>
        <source>the case has no target to draw</source>
        <translation>症例に描く標的がありません</translation>
    </message>
    <message>
        <source>the case has %1 targets</source>
        <translation>症例に標的が %1 個あります</translation>
    </message>
    <message>
        <source>name those to draw with --target</source>
        <translation>描く標的を --target で指定してください</translation>
    </message>
    <message>
        <source>the file exists already</source>
        <translation>ファイルは既にあります</translation>
    </message>
    <message>
        <source>choose another name, or --replace</source>
        <translation>別の名前を選ぶか、--replace を指定してください</translation>
    </message>
    <message>
        <source>FaceNav plan: %1</source>
        <translation>FaceNav plan: %1</translation>
    </message>
    <message>
        <source>FaceNav, not for diagnosis: %1</source>
        <translation>FaceNav, not for diagnosis: %1</translation>
    </message>
    <message>
        <source>FaceNav %1: planned target and coil (figure of eight) drawn into the voxels, not for diagnosis: %2</source>
        <translation>FaceNav %1: planned target and coil (figure of eight) drawn into the voxels, not for diagnosis: %2</translation>
    </message>
    <message>
        <source>FaceNav %1: planned target and coil (%2) drawn into the voxels, not for diagnosis: %3</source>
        <translation>FaceNav %1: planned target and coil (%2) drawn into the voxels, not for diagnosis: %3</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>フォルダーが空ではありません</translation>
    </message>
    <message>
        <source>choose another one, or --replace</source>
        <translation>別のものを選ぶか、--replace を指定してください</translation>
    </message>
    <message>
        <source>the folder holds something else than a data set of FaceNav</source>
        <translation>フォルダーに FaceNav のデータセット以外のものがあります</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>別のものを選んでください</translation>
    </message>
    <message>
        <source>the case has no MRI, to which other programs&apos; coordinates refer</source>
        <translation>症例に、ほかのプログラムの座標の基準となる MRI がありません</translation>
    </message>
    <message>
        <source>a subject&apos;s label has letters and digits only, not &apos;%1&apos;</source>
        <translation>被験者ラベルには英字と数字だけを使えます。&apos;%1&apos; は使えません</translation>
    </message>
    <message>
        <source>choose one with --subject</source>
        <translation>--subject で 1 つ選んでください</translation>
    </message>
    <message>
        <source>%1 is a folder, not one file for standard output</source>
        <translation>%1 はフォルダーで、標準出力に書ける 1 つのファイルではありません</translation>
    </message>
    <message>
        <source>name a folder with -o</source>
        <translation>-o でフォルダーを指定してください</translation>
    </message>
    <message>
        <source>a field is written as .vtp, .msh, .nii or .nii.gz</source>
        <translation>電場は .vtp、.msh、.nii、.nii.gz で書き出します</translation>
    </message>
    <message>
        <source>give one of these names</source>
        <translation>そのいずれかの名前を指定してください</translation>
    </message>
    <message>
        <source>the field is 0 everywhere</source>
        <translation>電場がどこでも 0 です</translation>
    </message>
    <message>
        <source>field in the brain</source>
        <translation>脳内の電場</translation>
    </message>
    <message>
        <source>a sphere fitted to the skull under the coil (radius %1 mm)</source>
        <translation>コイルの下の頭蓋骨に合わせた球 (半径 %1 mm)</translation>
    </message>
    <message>
        <source>a sphere fitted to the whole skull (radius %1 mm)</source>
        <translation>頭蓋骨全体に合わせた球 (半径 %1 mm)</translation>
    </message>
    <message>
        <source>skull under the coil</source>
        <translation>コイルの下の頭蓋骨</translation>
    </message>
    <message>
        <source>whole skull</source>
        <translation>頭蓋骨全体</translation>
    </message>
    <message>
        <source>scalp, skull, fluid and brain of the case (four shells with the fluid)</source>
        <translation>症例の頭皮、頭蓋骨、髄液、脳 (髄液を含む 4 層)</translation>
    </message>
    <message>
        <source>scalp, skull and brain of the case (three shells)</source>
        <translation>症例の頭皮、頭蓋骨、脳 (3 層)</translation>
    </message>
    <message>
        <source>the case has no brain model, so its field is not known</source>
        <translation>症例に脳モデルがないため、電場は分かりません</translation>
    </message>
    <message>
        <source>prepare it from a scan of the whole head</source>
        <translation>頭部全体のスキャンから準備してください</translation>
    </message>
    <message>
        <source>the case&apos;s four shells are not built, or were built before its masks changed</source>
        <translation>症例の 4 層モデルがまだないか、マスクの変更前に作られたものです</translation>
    </message>
    <message>
        <source>the case&apos;s three shells are not built, or were built before its masks changed</source>
        <translation>症例の 3 層モデルがまだないか、マスクの変更前に作られたものです</translation>
    </message>
    <message>
        <source>build them (&apos;facenav field --tier 2&apos; does), or use tier 1</source>
        <translation>作成する (&apos;facenav field --tier 2&apos;) か、段階 1 を使ってください</translation>
    </message>
    <message>
        <source>build them (&apos;facenav field&apos; does), or use tier 0</source>
        <translation>作成する (&apos;facenav field&apos;) か、段階 0 を使ってください</translation>
    </message>
    <message>
        <source>the file has the name &apos;%1&apos; twice</source>
        <translation>ファイルに名前 &apos;%1&apos; が 2 回あります</translation>
    </message>
    <message>
        <source>a file before it</source>
        <translation>前のファイル</translation>
    </message>
    <message>
        <source>the case</source>
        <translation>症例</translation>
    </message>
    <message>
        <source>%1 has a target of this name, and it is locked</source>
        <translation>%1に同じ名前の標的があり、ロックされています</translation>
    </message>
    <message>
        <source>%1 has a target of this name with another pose: give --replace, or rename it</source>
        <translation>%1に、同じ名前で姿勢の異なる標的があります: 「置き換える」にチェックを入れるか、名前を変えてください</translation>
    </message>
    <message>
        <source>its name %1</source>
        <translation>名前が%1</translation>
    </message>
    <message>
        <source>its session was imported before</source>
        <translation>そのセッションは以前に取り込まれています</translation>
    </message>
    <message>
        <source>a place only; facenav target makes a target there</source>
        <translation>位置のみ。そこに標的を作るには、計画の画面で座標を入力してください</translation>
    </message>
    <message>
        <source>its T1 &apos;%1&apos; cannot be compared with the case&apos;s: %2</source>
        <translation>T1 &apos;%1&apos; を症例の T1 と比べられません: %2</translation>
    </message>
    <message>
        <source>the times of its pulses name no zone: taken as UTC%1 (--utc-offset)</source>
        <translation>パルスの時刻にタイムゾーンがありません: UTC%1 として扱います</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>取り込まない</translation>
    </message>
    <message>
        <source>sform and qform</source>
        <translation>sform と qform</translation>
    </message>
    <message>
        <source>the sform is used</source>
        <translation>sform を使います</translation>
    </message>
    <message>
        <source>the qform is used</source>
        <translation>qform を使います</translation>
    </message>
    <message>
        <source>the field has no value at the target &apos;%1&apos;</source>
        <translation>標的 &apos;%1&apos; に電場の値がありません</translation>
    </message>
    <message>
        <source>import a field that reaches this part of the brain</source>
        <translation>脳のこの部分を含む電場を取り込んでください</translation>
    </message>
    <message>
        <source>the case has no brain mask, so the brain&apos;s part of a volume is not known</source>
        <translation>症例に脳マスクがないため、ボリュームのうち脳の部分が分かりません</translation>
    </message>
    <message>
        <source>import the field&apos;s mesh (.msh)</source>
        <translation>電場のメッシュ (.msh) を取り込んでください</translation>
    </message>
    <message>
        <source>the volume has no field in the brain of the case</source>
        <translation>ボリュームのうち症例の脳の部分に電場がありません</translation>
    </message>
    <message>
        <source>import a field of this patient</source>
        <translation>この患者の電場を取り込んでください</translation>
    </message>
    <message>
        <source>the case has no MRI, to which an imported field refers</source>
        <translation>症例に、取り込む電場の基準となる MRI がありません</translation>
    </message>
    <message>
        <source>the file does not say its rate: taken as 1 A/us, SimNIBS&apos;s default (--didt)</source>
        <translation>ファイルに変化率がありません: SimNIBS の既定値 1 A/us として扱います (--didt)</translation>
    </message>
    <message>
        <source>its maximum lies %1 mm from the target: was it computed for it?</source>
        <translation>最大点が標的から %1 mm 離れています: この標的用に計算されたものですか?</translation>
    </message>
    <message>
        <source>an imported field (%1)</source>
        <translation>取り込んだ電場 (%1)</translation>
    </message>
    <message>
        <source>the imported field is that of the pose of &apos;%1&apos; alone</source>
        <translation>取り込んだ電場は &apos;%1&apos; の姿勢だけのものです</translation>
    </message>
    <message>
        <source>use another tier for other poses</source>
        <translation>ほかの姿勢には別の段階を使ってください</translation>
    </message>
    <message>
        <source>no field was imported for the pose that &apos;%1&apos; has now</source>
        <translation>&apos;%1&apos; の現在の姿勢に対する電場は取り込まれていません</translation>
    </message>
    <message>
        <source>import one (&apos;facenav import CASE FIELD --target NAME&apos;)</source>
        <translation>取り込んでください (&apos;facenav import CASE FIELD --target NAME&apos;)</translation>
    </message>
    <message>
        <source>the field&apos;s head lies beside the case&apos;s head</source>
        <translation>電場の頭部が症例の頭部から外れています</translation>
    </message>
    <message>
        <source>import a field of this patient, in the coordinates of the case&apos;s MRI</source>
        <translation>症例の MRI の座標による、この患者の電場を取り込んでください</translation>
    </message>
    <message>
        <source>90 % of its scalp within %1 mm of the case&apos;s skin</source>
        <translation>頭皮の 90 % が症例の皮膚から %1 mm 以内です</translation>
    </message>
    <message>
        <source>the field&apos;s head is not the case&apos;s: a tenth of its scalp lies more than %1 mm off the skin (%2 allowed)</source>
        <translation>電場の頭部が症例のものではありません: 頭皮の 10 分の 1 が皮膚から %1 mm を超えて離れています (許容 %2)</translation>
    </message>
    <message>
        <source>its grid is that of the case&apos;s T1</source>
        <translation>格子は症例の T1 と同じです</translation>
    </message>
    <message>
        <source>it covers the case&apos;s T1 with voxels of another size</source>
        <translation>症例の T1 を別の大きさのボクセルで覆っています</translation>
    </message>
    <message>
        <source>its grid is not that of the case&apos;s T1</source>
        <translation>格子が症例の T1 と異なります</translation>
    </message>
    <message>
        <source>the field&apos;s T1 is not the case&apos;s: it has %1, the case&apos;s T1 %2, or another place</source>
        <translation>電場の T1 が症例のものではありません: 電場側は %1、症例の T1 は %2、または場所が異なります</translation>
    </message>
    <message>
        <source>import the field that was computed from the case&apos;s T1</source>
        <translation>症例の T1 から計算した電場を取り込んでください</translation>
    </message>
    <message>
        <source>the T1 of the field is not the case&apos;s: it has %1, the case&apos;s T1 %2, or another place</source>
        <translation>電場の T1 が症例のものではありません: 電場側は %1、症例の T1 は %2、または場所が異なります</translation>
    </message>
    <message>
        <source>the named T1 is the case&apos;s</source>
        <translation>指定した T1 は症例のものです</translation>
    </message>
    <message>
        <source>the field lies on another cortex: half of its points are more than %1 mm away</source>
        <translation>電場が別の皮質の上にあります: 点の半数が %1 mm を超えて離れています</translation>
    </message>
    <message>
        <source>it has no scalp to check; half of its points within %1 mm of the cortex</source>
        <translation>確認できる頭皮がありません。点の半数が皮質から %1 mm 以内です</translation>
    </message>
    <message>
        <source>no file beside it tells the coil&apos;s pose: it is taken to be the target&apos;s</source>
        <translation>コイルの姿勢を示すファイルが同じ場所にありません: 標的の姿勢として扱います</translation>
    </message>
    <message>
        <source>the field was computed for another pose: its coil stood %1 mm and %2 degrees off that of &apos;%3&apos;</source>
        <translation>電場は別の姿勢で計算されています: コイルが &apos;%3&apos; から %1 mm、%2 度ずれていました</translation>
    </message>
    <message>
        <source>name the target that it was computed for</source>
        <translation>計算の対象とした標的を指定してください</translation>
    </message>
    <message>
        <source>its coil stood %1 mm and %2 degrees off the target&apos;s pose</source>
        <translation>コイルが標的の姿勢から %1 mm、%2 度ずれていました</translation>
    </message>
    <message>
        <source>%1: the field is that of its own pose</source>
        <translation>%1: 電場はその姿勢自身のものです</translation>
    </message>
    <message>
        <source>a number above 0 was expected</source>
        <translation>0 より大きい数値が必要です</translation>
    </message>
    <message>
        <source>a name such as imported_field_1.msh was expected</source>
        <translation>imported_field_1.msh のような名前が必要です</translation>
    </message>
    <message>
        <source>holds values alone: the surface that they belong to is another file</source>
        <translation>値だけがあります: 対応する表面は別のファイルです</translation>
    </message>
    <message>
        <source>name it with --surface, such as lh.central.gii</source>
        <translation>--surface で指定してください (例: lh.central.gii)</translation>
    </message>
    <message>
        <source>holds %1 values, but the surface has %2 vertices</source>
        <translation>値は %1 個ですが、表面の頂点は %2 個です</translation>
    </message>
    <message>
        <source>name the surface that the field was written for (lh with lh, rh with rh)</source>
        <translation>電場が書かれた表面を指定してください (lh には lh、rh には rh)</translation>
    </message>
    <message>
        <source>holds values below 0: a part of the field, not its magnitude</source>
        <translation>0 未満の値があります: 電場の大きさではなく成分です</translation>
    </message>
    <message>
        <source>give the overlay of the magnitude (E.magn, E.norm)</source>
        <translation>大きさのオーバーレイ (E.magn、E.norm) を指定してください</translation>
    </message>
    <message>
        <source>give the image of the magnitude (magnE), or of the vectors (E)</source>
        <translation>大きさの画像 (magnE) またはベクトルの画像 (E) を指定してください</translation>
    </message>
    <message>
        <source>mesh of gmsh 2.2 with the brain&apos;s volume</source>
        <translation>脳のボリュームを持つ gmsh 2.2 のメッシュ</translation>
    </message>
    <message>
        <source>mesh of gmsh 2.2 with a surface</source>
        <translation>表面を持つ gmsh 2.2 のメッシュ</translation>
    </message>
    <message>
        <source>lies in the space of a template, by its header</source>
        <translation>ヘッダーによると、テンプレートの空間にあります</translation>
    </message>
    <message>
        <source>give the field in the subject&apos;s space (subject_volumes)</source>
        <translation>被験者の空間の電場 (subject_volumes) を指定してください</translation>
    </message>
    <message>
        <source>values on a surface of the cortex</source>
        <translation>皮質表面上の値</translation>
    </message>
    <message>
        <source>holds no electric field that is known</source>
        <translation>既知の形式の電場がありません</translation>
    </message>
    <message>
        <source>give a .msh, a NIfTI, a .vtp, or an overlay with its surface</source>
        <translation>.msh、NIfTI、.vtp、または表面付きのオーバーレイを指定してください</translation>
    </message>
    <message>
        <source>no target</source>
        <translation>標的なし</translation>
    </message>
    <message>
        <source>outside the usual tolerance</source>
        <translation>通常の許容範囲の外</translation>
    </message>
    <message>
        <source>facenav imported session</source>
        <translation>facenav imported session</translation>
    </message>
    <message>
        <source>session started</source>
        <translation>セッション開始</translation>
    </message>
    <message>
        <source>no brain model</source>
        <translation>脳モデルなし</translation>
    </message>
    <message>
        <source>click on the slice where the target lies</source>
        <translation>断面上で標的の場所をクリックしてください</translation>
    </message>
    <message>
        <source>the map is 0 everywhere</source>
        <translation>マップがどこでも 0 です</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>別のファイルを選んでください</translation>
    </message>
    <message>
        <source>name the file in it</source>
        <translation>中のファイルを指定してください</translation>
    </message>
    <message>
        <source>this kind of file is not known</source>
        <translation>この種類のファイルは不明です</translation>
    </message>
    <message>
        <source>give NIfTI, .trk .tck .trx, .ply .stl .obj .vtk or .vtp</source>
        <translation>NIfTI、.trk .tck .trx、.ply .stl .obj .vtk .vtp のいずれかを指定してください</translation>
    </message>
    <message>
        <source>the case has no atlas registration, which MNI space needs</source>
        <translation>MNI 空間に必要なアトラスの位置合わせが症例にありません</translation>
    </message>
    <message>
        <source>prepare it again with --replace (its targets are kept)</source>
        <translation>--replace で準備し直してください (標的は残ります)</translation>
    </message>
    <message>
        <source>most of it lies beside the head (%1 % within the MRI)</source>
        <translation>大部分が頭部の外にあります (MRI 内は %1 %)</translation>
    </message>
    <message>
        <source>is it of another person, in another space (--space), or LPS?</source>
        <translation>別の人、別の空間 (--space)、または LPS のものではありませんか?</translation>
    </message>
    <message>
        <source>the folder cannot be made (%1)</source>
        <translation>フォルダーを作成できません (%1)</translation>
    </message>
    <message>
        <source>the case has no overlay &apos;%1&apos;</source>
        <translation>症例にオーバーレイ &apos;%1&apos; はありません</translation>
    </message>
    <message>
        <source>--list-overlays shows its names</source>
        <translation>--list-overlays で名前を一覧できます</translation>
    </message>
    <message>
        <source>the file says that it lies in a template&apos;s space</source>
        <translation>ファイルによると、テンプレートの空間にあります</translation>
    </message>
    <message>
        <source>give --space mni, or --space native if it was made for this head</source>
        <translation>--space mni を、この頭部用に作られたものなら --space native を指定してください</translation>
    </message>
    <message>
        <source>unlock it first</source>
        <translation>先にロックを解除してください</translation>
    </message>
    <message>
        <source>there is a target &apos;%1&apos; already</source>
        <translation>標的 &apos;%1&apos; は既にあります</translation>
    </message>
    <message>
        <source>renamed from &apos;%1&apos;</source>
        <translation>&apos;%1&apos; から名前を変更</translation>
    </message>
    <message>
        <source>copied from &apos;%1&apos;</source>
        <translation>&apos;%1&apos; から複製</translation>
    </message>
    <message>
        <source>mirrored from &apos;%1&apos;</source>
        <translation>&apos;%1&apos; から鏡映</translation>
    </message>
    <message>
        <source>grid removed</source>
        <translation>格子を削除</translation>
    </message>
    <message>
        <source>the place lies %1 mm outside the head</source>
        <translation>その場所は頭部から %1 mm 外です</translation>
    </message>
    <message>
        <source>check the numbers, and whether they are MNI or RAS</source>
        <translation>数値と、MNI か RAS かを確認してください</translation>
    </message>
    <message>
        <source>the coil&apos;s file does not say how fast its current rises at 100 % output</source>
        <translation>コイルのファイルに、出力 100 % での電流変化率がありません</translation>
    </message>
    <message>
        <source>give the rate in A/us</source>
        <translation>A/us の値を入力してください</translation>
    </message>
    <message>
        <source>electric field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>comparison of poses</source>
        <translation>姿勢の比較</translation>
    </message>
    <message>
        <source>best pose</source>
        <translation>最良の姿勢</translation>
    </message>
    <message>
        <source>mirror image of the left one</source>
        <translation>左側の鏡像</translation>
    </message>
    <message>
        <source>hand area of the left M1</source>
        <translation>左 M1 の手の領域</translation>
    </message>
    <message>
        <source>hand knob, Yousry 1997; the start of the search for the hotspot, not the hotspot</source>
        <translation>ハンドノブ、Yousry 1997。ホットスポット探索の開始点で、ホットスポットそのものではありません</translation>
    </message>
    <message>
        <source>hand area of the right M1</source>
        <translation>右 M1 の手の領域</translation>
    </message>
    <message>
        <source>most anticorrelated with the subgenual cingulate in groups, Fox 2012</source>
        <translation>集団で膝下部帯状皮質と最も逆相関する点、Fox 2012</translation>
    </message>
    <message>
        <source>group target of later comparisons</source>
        <translation>その後の比較研究での集団の標的</translation>
    </message>
    <message>
        <source>F3 by Beam&apos;s method, from three tape measures</source>
        <translation>Beam 法による F3、巻尺の 3 計測から</translation>
    </message>
    <message>
        <source>F4 by Beam&apos;s method, from three tape measures</source>
        <translation>Beam 法による F4、巻尺の 3 計測から</translation>
    </message>
    <message>
        <source>site %1 of the 10-20 system</source>
        <translation>10-20 法の点 %1</translation>
    </message>
    <message>
        <source>there is no preset &apos;%1&apos;</source>
        <translation>プリセット &apos;%1&apos; はありません</translation>
    </message>
    <message>
        <source>choose one of: %1eeg:C3 and the other EEG sites</source>
        <translation>次のいずれかを選んでください: %1eeg:C3 などの脳波電極位置</translation>
    </message>
    <message>
        <source>the case has no atlas registration, which &apos;%1&apos; needs</source>
        <translation>&apos;%1&apos; に必要なアトラスの位置合わせが症例にありません</translation>
    </message>
    <message>
        <source>prepare it again with --replace (its targets are kept), or type RAS coordinates</source>
        <translation>--replace で準備し直す (標的は残ります) か、RAS 座標を入力してください</translation>
    </message>
    <message>
        <source>nasion-inion %1 mm, tragus-tragus %2 mm, circumference %3 mm: x %4 mm, y %5 mm, +- %6 mm by the landmarks</source>
        <translation>鼻根点-後頭結節 %1 mm、耳珠-耳珠 %2 mm、頭囲 %3 mm: x %4 mm、y %5 mm、ランドマークによる +- %6 mm</translation>
    </message>
    <message>
        <source>%1 +- %2 mm by the landmarks</source>
        <translation>%1 +- %2 mm (ランドマークによる)</translation>
    </message>
    <message>
        <source>the tape passes %1 mm over the skin there</source>
        <translation>巻尺がそこで皮膚から %1 mm 浮いています</translation>
    </message>
    <message>
        <source>is not the case&apos;s T1: its voxels hold another image</source>
        <translation>症例の T1 ではありません: ボクセルの画像が異なります</translation>
    </message>
    <message>
        <source>name the T1 that the case was prepared from</source>
        <translation>症例の準備に使った T1 を指定してください</translation>
    </message>
    <message>
        <source>imported from %1</source>
        <translation>%1 から取り込み</translation>
    </message>
    <message>
        <source>nothing was imported</source>
        <translation>何も取り込まれていません</translation>
    </message>
    <message>
        <source>whole brain</source>
        <translation>脳全体</translation>
    </message>
    <message>
        <source>look at the %1</source>
        <translation>%1 を確認してください</translation>
    </message>
    <message>
        <source>measuring the phi-theta surface</source>
        <translation>φ–θ 面を計測しています</translation>
    </message>
    <message>
        <source>the case has no MRI</source>
        <translation>症例に MRI がありません</translation>
    </message>
    <message>
        <source>prepare a case from an MRI</source>
        <translation>MRI から症例を準備してください</translation>
    </message>
    <message>
        <source>the case has no brain</source>
        <translation>症例に脳がありません</translation>
    </message>
    <message>
        <source>the electric field needs one; correct the brain mask</source>
        <translation>電場には脳が必要です。脳マスクを修正してください</translation>
    </message>
    <message>
        <source>electric field: surfaces</source>
        <translation>電場: 表面</translation>
    </message>
    <message>
        <source>give the folder of the DICOM files that the case was prepared from with --source</source>
        <translation>症例の準備に使った DICOM ファイルのフォルダーを --source で指定してください</translation>
    </message>
    <message>
        <source>the case has no MRI, so that no series belongs to it</source>
        <translation>症例に MRI がないため、対応するシリーズがありません</translation>
    </message>
    <message>
        <source>holds no series with the Series Instance UID of the case&apos;s MRI</source>
        <translation>症例の MRI の Series Instance UID を持つシリーズがありません</translation>
    </message>
    <message>
        <source>holds no series with the voxels of the case&apos;s MRI</source>
        <translation>症例の MRI と同じボクセルのシリーズがありません</translation>
    </message>
    <message>
        <source>give R A S in the patient&apos;s MRI</source>
        <translation>患者の MRI での R A S を指定してください</translation>
    </message>
    <message>
        <source>it has %1, the scan %2</source>
        <translation>%1 です。スキャンは %2 です</translation>
    </message>
    <message>
        <source>it lies %1 mm beside the scan</source>
        <translation>スキャンから %1 mm 外れています</translation>
    </message>
    <message>
        <source>it lies %1 to %2 mm beside the scan</source>
        <translation>スキャンから %1〜%2 mm 外れています</translation>
    </message>
    <message>
        <source>the mask&apos;s %1</source>
        <translation>マスクの %1</translation>
    </message>
    <message>
        <source>the mask lies on another grid than the case&apos;s scan: %1 by its sform; by its qform it fits</source>
        <translation>マスクの格子が症例のスキャンと異なります: sform では %1。qform では合います</translation>
    </message>
    <message>
        <source>the mask lies on another grid than the case&apos;s scan: %1</source>
        <translation>マスクの格子が症例のスキャンと異なります: %1</translation>
    </message>
    <message>
        <source>write its qform into its sform, if that is right</source>
        <translation>それが正しければ、qform を sform に書き込んでください</translation>
    </message>
    <message>
        <source>draw it on the case&apos;s mri.nii.gz</source>
        <translation>症例の mri.nii.gz の上に描いてください</translation>
    </message>
    <message>
        <source>region grow</source>
        <translation>領域拡張</translation>
    </message>
    <message>
        <source>fill holes</source>
        <translation>穴埋め</translation>
    </message>
    <message>
        <source>look at the</source>
        <translation>look at the</translation>
    </message>
    <message>
        <source>top of the head</source>
        <translation>頭頂</translation>
    </message>
    <message>
        <source>upper head</source>
        <translation>頭の上部</translation>
    </message>
    <message>
        <source>left side of the head</source>
        <translation>患者の頭の左側</translation>
    </message>
    <message>
        <source>an ear is</source>
        <translation>耳</translation>
    </message>
    <message>
        <source>side of the head is</source>
        <translation>頭の側面</translation>
    </message>
    <message>
        <source>overlap %1, correlation %2</source>
        <translation>重なり %1、相関 %2</translation>
    </message>
    <message>
        <source>the atlas does not fit this brain (%1): no MNI coordinates or labels</source>
        <translation>アトラスがこの脳に合いません (%1): MNI 座標もラベルもありません</translation>
    </message>
    <message>
        <source>modelling the brain&apos;s surface</source>
        <translation>脳の表面をモデル化しています</translation>
    </message>
    <message>
        <source>no brain model: %1; the case holds the scalp alone</source>
        <translation>脳モデルなし: %1。症例には頭皮だけがあります</translation>
    </message>
    <message>
        <source>no MNI coordinates: %1</source>
        <translation>MNI 座標なし: %1</translation>
    </message>
    <message>
        <source>no patient is named: the case has no label</source>
        <translation>患者名がありません: 症例にラベルはありません</translation>
    </message>
    <message>
        <source>choose another folder, or --replace to model this scan again (targets and sessions are kept)</source>
        <translation>別のフォルダーを選ぶか、--replace でこのスキャンをモデル化し直してください (標的とセッションは残ります)</translation>
    </message>
    <message>
        <source>no such folder to make the case in</source>
        <translation>症例を作るフォルダーがありません</translation>
    </message>
    <message>
        <source>contrast: looks like %1</source>
        <translation>コントラスト: %1 のようです</translation>
    </message>
    <message>
        <source>writing the case</source>
        <translation>症例を書き込んでいます</translation>
    </message>
    <message>
        <source>the scan was rejected by %1: %2</source>
        <translation>スキャンは %1 により却下されました: %2</translation>
    </message>
    <message>
        <source>nobody has signed it off</source>
        <translation>誰も承認していません</translation>
    </message>
    <message>
        <source>sign-off of %1 void: %2</source>
        <translation>%1 の承認は無効: %2</translation>
    </message>
    <message>
        <source>sign-off of %1 void: %2 changed</source>
        <translation>%1 の承認は無効: %2 が変更されました</translation>
    </message>
    <message>
        <source>the case is not signed off</source>
        <translation>症例が承認されていません</translation>
    </message>
    <message>
        <source>have it checked (Prepare, step 4)</source>
        <translation>確認を受けてください (準備、手順 4)</translation>
    </message>
    <message>
        <source>give a name or initials with --by</source>
        <translation>--by で氏名またはイニシャルを指定してください</translation>
    </message>
    <message>
        <source>the import check calls this scan not usable: say why it is signed off all the same</source>
        <translation>取り込み確認で、このスキャンは使用不可です: それでも承認する理由を入力してください</translation>
    </message>
    <message>
        <source>give the reason with --note, or reject the scan with --reject</source>
        <translation>--note で理由を指定するか、--reject でスキャンを却下してください</translation>
    </message>
    <message>
        <source>give the offset of the clocks in seconds (--offset; 0: they are the same clock)</source>
        <translation>時計のずれを秒で入力してください (--offset。0: 同じ時計)</translation>
    </message>
    <message>
        <source>the times do not fit the session&apos;s pulses: at best %1 of %2 rows meet one</source>
        <translation>時刻がセッションのパルスと合いません: 最良でも %2 行中 %1 行だけがパルスと一致します</translation>
    </message>
    <message>
        <source>two clock offsets fit nearly alike (%1 and %2 of %3 rows meet a pulse)</source>
        <translation>2 つの時計のずれがほぼ同じくらい合います (%3 行中 %1 行と %2 行がパルスと一致)</translation>
    </message>
    <message>
        <source>%1 %2: no pulse at its time</source>
        <translation>%1 %2: その時刻にパルスがありません</translation>
    </message>
    <message>
        <source>%1 %2: several pulses are at its time</source>
        <translation>%1 %2: その時刻に複数のパルスがあります</translation>
    </message>
    <message>
        <source>no pulse at its time</source>
        <translation>その時刻にパルスがありません</translation>
    </message>
    <message>
        <source>several pulses are at its time</source>
        <translation>その時刻に複数のパルスがあります</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time</source>
        <translation>&apos;%1&apos; は時刻ではありません</translation>
    </message>
    <message>
        <source>2026-11-23T14:05:09.123Z is expected</source>
        <translation>2026-11-23T14:05:09.123Z の形式が必要です</translation>
    </message>
    <message>
        <source>an MEP of %1 uV is not possible</source>
        <translation>%1 uV の MEP はあり得ません</translation>
    </message>
    <message>
        <source>there is no MEP in the file</source>
        <translation>ファイルに MEP がありません</translation>
    </message>
    <message>
        <source>no pulse of the session has a time on the clock utc</source>
        <translation>セッションに utc の時計の時刻を持つパルスがありません</translation>
    </message>
    <message>
        <source>no pulse of the session has a time on the clock t_s</source>
        <translation>セッションに t_s の時計の時刻を持つパルスがありません</translation>
    </message>
    <message>
        <source>the session&apos;s pulses were kept by an older version</source>
        <translation>セッションのパルスは以前のバージョンで記録されています</translation>
    </message>
    <message>
        <source>%1 %2: another row is at the same pulse, %3</source>
        <translation>%1 %2: 別の行 %3 が同じパルスにあります</translation>
    </message>
    <message>
        <source>%1 MEPs from %2; clock offset %3 s</source>
        <translation>MEP %1 個 (%2); 時計のずれ %3 s</translation>
    </message>
    <message>
        <source>(found: %1 of %2 rows fit, %3 under the next best)</source>
        <translation>(自動: %2 行中 %1 行が一致、次善では %3)</translation>
    </message>
    <message>
        <source>(given: %1 of %2 rows fit)</source>
        <translation>(指定: %2 行中 %1 行が一致)</translation>
    </message>
    <message>
        <source>largest difference %1 ms</source>
        <translation>最大の差 %1 ms</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>%1 を除外</translation>
    </message>
    <message>
        <source>Coloured by %1: dark %2 %3, bright %4 %5</source>
        <translation>%1 で色分け: 暗い色 %2 %3、明るい色 %4 %5</translation>
    </message>
    <message>
        <source>Map of the MEPs on the brain&apos;s surface (Gaussian, sigma %1 mm): dark 0, bright %2 uV. Peak %3 uV at %4 %5 %6, centre of gravity %7 %8 %9 (MRI, RAS mm), area with %10 uV or more %11 mm2, %12 of %13 pulses with a response</source>
        <translation>脳表面の MEP マップ (ガウス、σ %1 mm): 暗い色 0、明るい色 %2 uV。最大 %3 uV (%4 %5 %6)、重心 %7 %8 %9 (MRI、RAS mm)、%10 uV 以上の面積 %11 mm2、%13 パルス中 %12 で反応あり</translation>
    </message>
    <message>
        <source>From the side of the target. %1</source>
        <translation>標的の側から。%1</translation>
    </message>
    <message>
        <source>From above, patient&apos;s front upwards; same colours</source>
        <translation>上から、患者の前方が上。色は同じ</translation>
    </message>
    <message>
        <source>FaceNav session %1</source>
        <translation>FaceNav session %1</translation>
    </message>
    <message>
        <source>take in</source>
        <translation>除外を解除</translation>
    </message>
    <message>
        <source>frame %1 is of another moment than the session&apos;s</source>
        <translation>フレーム %1 の時刻がセッションと異なります</translation>
    </message>
    <message>
        <source>choose the recording of this session</source>
        <translation>このセッションの記録を選んでください</translation>
    </message>
    <message>
        <source>no frame of the session is in this recording</source>
        <translation>この記録にセッションのフレームがありません</translation>
    </message>
    <message>
        <source>poses.csv has no frames</source>
        <translation>poses.csv にフレームがありません</translation>
    </message>
    <message>
        <source>there is nothing to replay</source>
        <translation>再生するものがありません</translation>
    </message>
    <message>
        <source>no pictures were kept with the session</source>
        <translation>セッションとともに保存された画像がありません</translation>
    </message>
    <message>
        <source>face lost: %1</source>
        <translation>顔の追跡喪失: %1</translation>
    </message>
    <message>
        <source>coil lost: %1</source>
        <translation>コイルの追跡喪失: %1</translation>
    </message>
    <message>
        <source>the poses are not aligned with the MRI</source>
        <translation>姿勢が MRI と位置合わせされていません</translation>
    </message>
    <message>
        <source>the poses are those of the marker, not of the coil</source>
        <translation>姿勢がコイルではなくマーカーのものです</translation>
    </message>
    <message>
        <source>has no EMG%1; its streams: %2</source>
        <translation>EMG がありません%1。ストリーム: %2</translation>
    </message>
    <message>
        <source>has no EMG named &apos;%1&apos;; its streams: %2</source>
        <translation>&apos;%1&apos; という EMG がありません。ストリーム: %2</translation>
    </message>
    <message>
        <source>has several streams of EMG%1; its streams: %2</source>
        <translation>EMG のストリームが複数あります%1。ストリーム: %2</translation>
    </message>
    <message>
        <source>has several streams of EMG named &apos;%1&apos;; its streams: %2</source>
        <translation>&apos;%1&apos; という EMG のストリームが複数あります。ストリーム: %2</translation>
    </message>
    <message>
        <source>name it: --emg STREAM:CHANNEL</source>
        <translation>STREAM:CHANNEL で指定してください</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has no rate</source>
        <translation>ストリーム &apos;%1&apos; にサンプリング周波数がありません</translation>
    </message>
    <message>
        <source>name another: --emg STREAM:CHANNEL</source>
        <translation>別のものを STREAM:CHANNEL で指定してください</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has %2 channels</source>
        <translation>ストリーム &apos;%1&apos; のチャンネルは %2 個です</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has %2 channels: %3</source>
        <translation>ストリーム &apos;%1&apos; のチャンネルは %2 個です: %3</translation>
    </message>
    <message>
        <source>name one: --emg %1:CHANNEL, by its label or number</source>
        <translation>ラベルまたは番号で 1 つ指定してください: %1:CHANNEL</translation>
    </message>
    <message>
        <source>the EMG &apos;%1&apos; does not say its unit</source>
        <translation>EMG &apos;%1&apos; に単位がありません</translation>
    </message>
    <message>
        <source>the EMG&apos;s unit &apos;%1&apos; is not known</source>
        <translation>EMG の単位 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>give it: --emg-unit uV, mV or V</source>
        <translation>uV、mV、V のいずれかを指定してください</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has several markers: %2</source>
        <translation>ストリーム &apos;%1&apos; に複数のマーカーがあります: %2</translation>
    </message>
    <message>
        <source>name the pulse&apos;s: --markers %1:MARKER</source>
        <translation>パルスのものを指定してください: %1:MARKER</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has no such marker%2</source>
        <translation>ストリーム &apos;%1&apos; にそのマーカーはありません%2</translation>
    </message>
    <message>
        <source>the stream &apos;%1&apos; has no such marker; it has %2</source>
        <translation>ストリーム &apos;%1&apos; にそのマーカーはありません。あるのは %2 です</translation>
    </message>
    <message>
        <source>name another: --markers STREAM:MARKER</source>
        <translation>別のものを STREAM:MARKER で指定してください</translation>
    </message>
    <message>
        <source>has no such markers%1</source>
        <translation>そのマーカーはありません%1</translation>
    </message>
    <message>
        <source>has no such markers: %1</source>
        <translation>そのマーカーはありません: %1</translation>
    </message>
    <message>
        <source>has several streams of markers%1</source>
        <translation>マーカーのストリームが複数あります%1</translation>
    </message>
    <message>
        <source>has several streams of markers: %1</source>
        <translation>マーカーのストリームが複数あります: %1</translation>
    </message>
    <message>
        <source>name the pulses&apos;: --markers STREAM:MARKER</source>
        <translation>パルスのものを STREAM:MARKER で指定してください</translation>
    </message>
    <message>
        <source>the EMG &apos;%1&apos; has %2 samples a second, too few for an MEP</source>
        <translation>EMG &apos;%1&apos; は毎秒 %2 サンプルです。MEP には少なすぎます</translation>
    </message>
    <message>
        <source>record it at 1000 or more</source>
        <translation>1000 以上で記録してください</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood</source>
        <translation>&apos;%1&apos; が理解できません</translation>
    </message>
    <message>
        <source>the file %1; used up to there</source>
        <translation>ファイルが%1。そこまでを使います</translation>
    </message>
    <message>
        <source>EMG &apos;%1&apos;, channel %2, %3 to %4 ms after the %5 markers of &apos;%6&apos;</source>
        <translation>EMG &apos;%1&apos;、チャンネル %2、&apos;%6&apos; のマーカー %5 個の後 %3〜%4 ms</translation>
    </message>
    <message>
        <source>%1 markers have no usable EMG after them: left out</source>
        <translation>%1 個のマーカーの後に使える EMG がありません: 除きます</translation>
    </message>
    <message>
        <source>check its name</source>
        <translation>名前を確認してください</translation>
    </message>
    <message>
        <source>is no XDF recording</source>
        <translation>XDF の記録ではありません</translation>
    </message>
    <message>
        <source>give a file of LabRecorder</source>
        <translation>LabRecorder のファイルを指定してください</translation>
    </message>
    <message>
        <source>is damaged or cut short at byte %1</source>
        <translation>%1 バイト目で壊れているか、切れています</translation>
    </message>
    <message>
        <source>has no streams</source>
        <translation>ストリームがありません</translation>
    </message>
    <message>
        <source>%1, before any stream</source>
        <translation>%1 (ストリームより前)</translation>
    </message>
    <message>
        <source>record it again, or copy it again</source>
        <translation>記録し直すか、もう一度コピーしてください</translation>
    </message>
    <message>
        <source>has more than 64 MB of markers</source>
        <translation>マーカーが 64 MB を超えています</translation>
    </message>
    <message>
        <source>record fewer streams of text</source>
        <translation>文字のストリームを減らして記録してください</translation>
    </message>
    <message>
        <source>has damaged samples in stream &apos;%1&apos;</source>
        <translation>ストリーム &apos;%1&apos; に壊れたサンプルがあります</translation>
    </message>
    <message>
        <source>cannot be read any more</source>
        <translation>もう読み込めません</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>ディスクを確認してください</translation>
    </message>
    <message>
        <source>stream &apos;%1&apos; has more than 250 million samples</source>
        <translation>ストリーム &apos;%1&apos; のサンプルが 2 億 5000 万を超えています</translation>
    </message>
    <message>
        <source>record each session in a file of its own</source>
        <translation>セッションごとに別のファイルに記録してください</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>left picture: %1</source>
        <translation>左の画像: %1</translation>
    </message>
    <message>
        <source>right picture: %1</source>
        <translation>右の画像: %1</translation>
    </message>
    <message>
        <source>the pictures are %1 x %2 px in place of %3 x %4</source>
        <translation>画像が %3 x %4 ではなく %1 x %2 px です</translation>
    </message>
    <message>
        <source>use pictures of one camera pair at one resolution</source>
        <translation>1 組のカメラの同じ解像度の画像を使ってください</translation>
    </message>
    <message>
        <source>no board is seen: the picture is dark, more light</source>
        <translation>ボードが見えません: 画像が暗いため、明るくしてください</translation>
    </message>
    <message>
        <source>no board is seen</source>
        <translation>ボードが見えません</translation>
    </message>
    <message>
        <source>the right camera does not see the whole board</source>
        <translation>右カメラからボード全体が見えません</translation>
    </message>
    <message>
        <source>the left camera does not see the whole board</source>
        <translation>左カメラからボード全体が見えません</translation>
    </message>
    <message>
        <source>the board is too dark: more light, or a longer exposure</source>
        <translation>ボードが暗すぎます: 明るくするか、露光を長くしてください</translation>
    </message>
    <message>
        <source>the board is too bright: turn it from the lamp, or dim the tablet</source>
        <translation>ボードが明るすぎます: 照明からそらすか、タブレットを暗くしてください</translation>
    </message>
    <message>
        <source>the board is blurred: hold it still, or set the focus</source>
        <translation>ボードがぼけています: 静止させるか、ピントを合わせてください</translation>
    </message>
    <message>
        <source>this view is there already: %1</source>
        <translation>この視点は既にあります: %1</translation>
    </message>
    <message>
        <source>hold the board still</source>
        <translation>ボードを静止させてください</translation>
    </message>
    <message>
        <source>hold the board before both cameras, and still</source>
        <translation>ボードを両方のカメラの前に持ち、静止させてください</translation>
    </message>
    <message>
        <source>turn the board&apos;s left edge away from the cameras</source>
        <translation>ボードの左端をカメラから遠ざけるように回してください</translation>
    </message>
    <message>
        <source>turn the board&apos;s right edge away from the cameras</source>
        <translation>ボードの右端をカメラから遠ざけるように回してください</translation>
    </message>
    <message>
        <source>lean the board&apos;s top edge back</source>
        <translation>ボードの上端を後ろへ倒してください</translation>
    </message>
    <message>
        <source>lean the board&apos;s bottom edge back</source>
        <translation>ボードの下端を後ろへ倒してください</translation>
    </message>
    <message>
        <source>bring the board nearer, then farther away</source>
        <translation>ボードを近づけ、次に遠ざけてください</translation>
    </message>
    <message>
        <source>hold the board at the %1 of the left picture</source>
        <translation>ボードを左の画像の %1 に持ってください</translation>
    </message>
    <message>
        <source>hold the board at the %1 of the right picture</source>
        <translation>ボードを右の画像の %1 に持ってください</translation>
    </message>
    <message>
        <source>these views are enough</source>
        <translation>視点は十分です</translation>
    </message>
    <message>
        <source>hold the board elsewhere, tilted otherwise, and still</source>
        <translation>ボードを別の場所で別の傾きに持ち、静止させてください</translation>
    </message>
    <message>
        <source>to its left</source>
        <translation>その左へ</translation>
    </message>
    <message>
        <source>to its right</source>
        <translation>その右へ</translation>
    </message>
    <message>
        <source>bring the cameras nearer to the face</source>
        <translation>カメラを顔に近づけてください</translation>
    </message>
    <message>
        <source>move the cameras away from the face</source>
        <translation>カメラを顔から遠ざけてください</translation>
    </message>
    <message>
        <source>the distance is good</source>
        <translation>距離は適切です</translation>
    </message>
    <message>
        <source>turn the %1 camera %2</source>
        <translation>%1 側カメラを %2 回してください</translation>
    </message>
    <message>
        <source>one camera is much nearer, or has another lens: use two equal cameras</source>
        <translation>一方のカメラがずっと近いか、レンズが異なります: 同型のカメラ 2 台を使ってください</translation>
    </message>
    <message>
        <source>bring both cameras to one height and tilt</source>
        <translation>両方のカメラの高さと傾きをそろえてください</translation>
    </message>
    <message>
        <source>both cameras see the whole face</source>
        <translation>両方のカメラから顔全体が見えます</translation>
    </message>
    <message>
        <source>more light: the %1 picture is too dark</source>
        <translation>明るくしてください: %1 側の画像が暗すぎます</translation>
    </message>
    <message>
        <source>less light: the %1 picture is too bright</source>
        <translation>暗くしてください: %1 側の画像が明るすぎます</translation>
    </message>
    <message>
        <source>one picture is much darker: move the lamp to the middle</source>
        <translation>一方の画像がずっと暗くなっています: 照明を中央へ移してください</translation>
    </message>
    <message>
        <source>the light is good</source>
        <translation>明るさは適切です</translation>
    </message>
    <message>
        <source>set the focus of the left camera</source>
        <translation>左カメラのピントを合わせてください</translation>
    </message>
    <message>
        <source>set the focus of the right camera</source>
        <translation>右カメラのピントを合わせてください</translation>
    </message>
    <message>
        <source>the focus is good</source>
        <translation>ピントは適切です</translation>
    </message>
    <message>
        <source>let a person sit where the patient will sit, and look at the cameras</source>
        <translation>患者が座る場所に人が座り、カメラを見てください</translation>
    </message>
    <message>
        <source>turn the right camera to the face: it does not see it</source>
        <translation>右カメラを顔に向けてください: 顔が見えていません</translation>
    </message>
    <message>
        <source>turn the left camera to the face: it does not see it</source>
        <translation>左カメラを顔に向けてください: 顔が見えていません</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>まだ画像がありません</translation>
    </message>
    <message>
        <source>the cameras are placed well</source>
        <translation>カメラは適切に設置されています</translation>
    </message>
    <message>
        <source>in the last session: %1</source>
        <translation>前回のセッションで: %1</translation>
    </message>
    <message>
        <source>the jig carries the same marker as the coil (%1): print another one for the jig</source>
        <translation>治具のマーカーがコイルと同じです (%1): 治具用に別のマーカーを印刷してください</translation>
    </message>
    <message>
        <source>the point slips by %1 mm: keep it in its place on the tip while you turn the coil</source>
        <translation>点が %1 mm ずれます: コイルを回す間、先端に当てたままにしてください</translation>
    </message>
    <message>
        <source>turn the coil farther, the tip in its place</source>
        <translation>先端に当てたまま、コイルをさらに回してください</translation>
    </message>
    <message>
        <source>this is another coil: its marker is %1 id %2, not %3; take the right one, or choose this one</source>
        <translation>別のコイルです: マーカーが %3 ではなく %1 id %2 です。正しいものを持つか、このコイルを選んでください</translation>
    </message>
    <message>
        <source>the jig&apos;s marker is seen, the coil&apos;s (%1) is not: turn both markers to the cameras</source>
        <translation>治具のマーカーは見えますが、コイルのマーカー (%1) が見えません: 両方のマーカーをカメラに向けてください</translation>
    </message>
    <message>
        <source>hold the coil so that both cameras see its marker (%1)</source>
        <translation>両方のカメラからマーカー (%1) が見えるようにコイルを持ってください</translation>
    </message>
    <message>
        <source>the coil stands still: turn it by 30 degrees and more to all sides, its point on the tip</source>
        <translation>コイルが止まっています: 点を先端に当てたまま、全方向に 30 度以上回してください</translation>
    </message>
    <message>
        <source>the marker is recognised</source>
        <translation>マーカーを認識しました</translation>
    </message>
    <message>
        <source>stand the middle of the coil&apos;s face on a fixed tip, and turn the coil about it in all directions</source>
        <translation>コイル面の中央を固定した先端に当て、そのまわりに全方向へコイルを回してください</translation>
    </message>
    <message>
        <source>now a point in the middle of the handle on the tip, and turn the coil</source>
        <translation>次に、ハンドル中央の点を先端に当てて、コイルを回してください</translation>
    </message>
    <message>
        <source>now a point at the left of the face, seen from the handle, on the tip, and turn the coil</source>
        <translation>次に、ハンドルから見て面の左側の点を先端に当てて、コイルを回してください</translation>
    </message>
    <message>
        <source>both markers are seen: turn coil and jig a little, and hold them still</source>
        <translation>両方のマーカーが見えます: コイルと治具を少し回し、静止させてください</translation>
    </message>
    <message>
        <source>the coil&apos;s marker is seen, the jig&apos;s (%1) is not: put the jig on the coil, its marker to both cameras</source>
        <translation>コイルのマーカーは見えますが、治具のマーカー (%1) が見えません: 治具をコイルに載せ、マーカーを両方のカメラに向けてください</translation>
    </message>
    <message>
        <source>the coil is calibrated: +-%1 mm, +-%2 deg</source>
        <translation>コイルの較正が完了しました: +-%1 mm、+-%2 deg</translation>
    </message>
    <message>
        <source>point the projector at a face, or at a wall with something before it, and hold still</source>
        <translation>プロジェクターを顔、または前に物のある壁に向け、静止させてください</translation>
    </message>
    <message>
        <source>nothing may move now</source>
        <translation>今は何も動かさないでください</translation>
    </message>
    <message>
        <source>the cameras give no picture: check their cables, open them again, and take the scene again</source>
        <translation>カメラの画像が来ません: ケーブルを確認し、カメラを開き直して、シーンを撮影し直してください</translation>
    </message>
    <message>
        <source>calibrated: %1 px, from %2 to %3 mm; another scene makes it better</source>
        <translation>較正済み: %1 px、%2〜%3 mm。シーンを追加すると精度が上がります</translation>
    </message>
    <message>
        <source>the disk has space for %1 s only, %2 s are asked for</source>
        <translation>ディスクの空きは %1 s 分だけです。指定は %2 s です</translation>
    </message>
    <message>
        <source>free some space, or record a shorter time</source>
        <translation>空き容量を増やすか、短い時間を撮影してください</translation>
    </message>
    <message>
        <source>%1 pairs in %2 s (%3 a second)</source>
        <translation>%2 s で %1 組 (毎秒 %3)</translation>
    </message>
    <message>
        <source>the right picture is %1 ms later than the left</source>
        <translation>右の画像が左より %1 ms 遅れています</translation>
    </message>
    <message>
        <source>%1 pairs are missing: the disk was too slow</source>
        <translation>%1 組が欠けています: ディスクが遅すぎました</translation>
    </message>
    <message>
        <source>the cameras gave no picture</source>
        <translation>カメラの画像が来ませんでした</translation>
    </message>
    <message>
        <source>check them with: facenav cameras --try 2</source>
        <translation>facenav cameras --try 2 で点検してください</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>使用者が中止しました</translation>
    </message>
    <message>
        <source>%1; nothing was kept</source>
        <translation>%1。何も保存されていません</translation>
    </message>
    <message>
        <source>the cameras gave no more picture</source>
        <translation>カメラの画像が来なくなりました</translation>
    </message>
    <message>
        <source>open them again</source>
        <translation>開き直してください</translation>
    </message>
    <message>
        <source>the two files have no pair of pictures</source>
        <translation>2 つのファイルに画像の組がありません</translation>
    </message>
    <message>
        <source>choose others</source>
        <translation>別のものを選んでください</translation>
    </message>
    <message>
        <source>%1 read: the files are at their end</source>
        <translation>%1 を読み込みました: ファイルが終わりました</translation>
    </message>
    <message>
        <source>%1 read so far</source>
        <translation>読み込み済み %1</translation>
    </message>
    <message>
        <source>the files are at their end: %1</source>
        <translation>ファイルが終わりました: %1</translation>
    </message>
    <message>
        <source>whether the calibration holds is not clear yet: both cameras must see the face or the coil&apos;s marker</source>
        <translation>較正が正しいかまだ分かりません: 両方のカメラから顔またはコイルのマーカーが見えなければなりません</translation>
    </message>
    <message>
        <source>the calibration holds: the coil&apos;s marker measures %1 mm, %2 mm true</source>
        <translation>較正は正しく保たれています: コイルのマーカーの計測値 %1 mm、正しくは %2 mm</translation>
    </message>
    <message>
        <source>the check of %1 found a fault that is not repaired: %2</source>
        <translation>%1 の点検で見つかった不具合が修復されていません: %2</translation>
    </message>
    <message>
        <source>cameras, picture size and adjustments are as kept; %1</source>
        <translation>カメラ、画像サイズ、設定は保存時のままです。%1</translation>
    </message>
    <message>
        <source>not as kept</source>
        <translation>保存時と異なります</translation>
    </message>
    <message>
        <source>set again as kept</source>
        <translation>保存時の値に戻しました</translation>
    </message>
    <message>
        <source>the coil&apos;s marker fits the calibration and the face does not: hold both still, and check the cameras with the board</source>
        <translation>コイルのマーカーは較正と合いますが、顔が合いません: 両方を静止させ、ボードでカメラを点検してください</translation>
    </message>
    <message>
        <source>calibrate the cameras first</source>
        <translation>先にカメラを較正してください</translation>
    </message>
    <message>
        <source>the first place fits: now move it nearer or farther, by %1 mm at least, and hold it still</source>
        <translation>最初の場所は合っています: 次に %1 mm 以上近づけるか遠ざけて、静止させてください</translation>
    </message>
    <message>
        <source>hold the board in a new place, or the coil with its marker, before both cameras</source>
        <translation>ボード、またはマーカー付きのコイルを、両方のカメラの前の新しい場所で静止させてください</translation>
    </message>
    <message>
        <source>it is measured: hold it still</source>
        <translation>計測しています: 静止させてください</translation>
    </message>
    <message>
        <source>view taken: %1</source>
        <translation>視点を撮影しました: %1</translation>
    </message>
    <message>
        <source>these cameras are calibrated: go on</source>
        <translation>カメラは較正済みです: 次へ進んでください</translation>
    </message>
    <message>
        <source>the calibration is calculated: some seconds</source>
        <translation>較正を計算しています: 数秒かかります</translation>
    </message>
    <message>
        <source>a point at %1 mm is measured to +-%2 mm</source>
        <translation>%1 mm の点の計測精度は +-%2 mm です</translation>
    </message>
    <message>
        <source>%1 is not used: %2</source>
        <translation>%1 は使いません: %2</translation>
    </message>
    <message>
        <source>calibrated; its uncertainty is not known: take more views</source>
        <translation>較正済み。不確かさは不明です: 視点を増やしてください</translation>
    </message>
    <message>
        <source>calibrated: +-%1 mm at the target; go on</source>
        <translation>較正済み: 標的で +-%1 mm。次へ進んでください</translation>
    </message>
    <message>
        <source>calibrated, but only to +-%1 mm: take more views, tilted and near</source>
        <translation>較正済みですが、+-%1 mm までです: 傾けて近くから撮影した視点を増やしてください</translation>
    </message>
    <message>
        <source>the coil&apos;s marker is seen</source>
        <translation>コイルのマーカーが見えます</translation>
    </message>
    <message>
        <source>no marker is seen</source>
        <translation>マーカーが見えません</translation>
    </message>
    <message>
        <source>the jig&apos;s marker is seen</source>
        <translation>治具のマーカーが見えます</translation>
    </message>
    <message>
        <source>no jig is seen</source>
        <translation>治具が見えません</translation>
    </message>
    <message>
        <source>the shutter is known: a picture is read in %1 ms by the left camera, in %2 ms by the right</source>
        <translation>シャッターを測定しました: 1 枚の読み出しは左カメラ %1 ms、右カメラ %2 ms です</translation>
    </message>
    <message>
        <source>the waved coil is hardly ever in one place for both cameras: they do not expose at the same time; a session allows for that, by the moving head</source>
        <translation>振ったコイルの位置が両方のカメラでほとんど一致しません: 露光が同時ではありません。セッションでは頭の動きによって補正します</translation>
    </message>
    <message>
        <source>no delay between the rows shows: these cameras need no correction</source>
        <translation>行間の遅れは見られません: このカメラに補正は不要です</translation>
    </message>
    <message>
        <source>the rows are read as this pair states: nothing changes</source>
        <translation>行の読み出しはこのペアの記載どおりです: 変更はありません</translation>
    </message>
    <message>
        <source>hold the coil so that both cameras see its marker, and wave it</source>
        <translation>両方のカメラからマーカーが見えるようにコイルを持って、振ってください</translation>
    </message>
    <message>
        <source>wave the coil quicker, to and fro and up and down, its marker to both cameras (%1 of %2 cm a second)</source>
        <translation>マーカーを両方のカメラに向けたまま、前後、上下にもっと速く振ってください (毎秒 %1 / %2 cm)</translation>
    </message>
    <message>
        <source>good: wave on, its marker to both cameras</source>
        <translation>よい速さです: マーカーを両方のカメラに向けたまま、振り続けてください</translation>
    </message>
    <message>
        <source>the calibration holds as far as a face shows it (rows %1 px apart); only the coil&apos;s marker shows a sideways turn, and a roll where the face is in the pictures&apos; middle</source>
        <translation>顔から分かる範囲では較正は正しく保たれています (行のずれ %1 px)。横への回転と、顔が画像の中央にあるときの傾きは、コイルのマーカーでしか分かりません</translation>
    </message>
    <message>
        <source>the cameras have moved against each other since their calibration (rows %1 px apart on the face)</source>
        <translation>較正後にカメラ同士の位置がずれています (顔での行のずれ %1 px)</translation>
    </message>
    <message>
        <source>the head&apos;s poses are not placed in the MRI</source>
        <translation>頭の姿勢が MRI の中に置かれていません</translation>
    </message>
    <message>
        <source>track again with --case</source>
        <translation>--case を付けて追跡し直してください</translation>
    </message>
    <message>
        <source>no such hunting grid</source>
        <translation>その探索用の格子はありません</translation>
    </message>
    <message>
        <source>give 1 to 15 rows and columns, and 1 to 40 mm between them</source>
        <translation>行と列を 1〜15、間隔を 1〜40 mm で指定してください</translation>
    </message>
    <message>
        <source>stopped by %1</source>
        <translation>%1 により停止</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>何も送られていません</translation>
    </message>
    <message>
        <source>the case has this target already</source>
        <translation>症例には既にこの標的があります</translation>
    </message>
    <message>
        <source>target &apos;%1&apos; from %2</source>
        <translation>%2 からの標的 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>sent by OpenIGTLink</source>
        <translation>OpenIGTLink で送信</translation>
    </message>
    <message>
        <source>it is the identity: nobody has placed it</source>
        <translation>恒等変換です: 位置が指定されていません</translation>
    </message>
    <message>
        <source>%1: offered; the chosen target is as before</source>
        <translation>%1: 候補として受け取りました。選択中の標的は変わりません</translation>
    </message>
    <message>
        <source>%1: not taken: %2</source>
        <translation>%1: 受け取れません: %2</translation>
    </message>
    <message>
        <source>target offered</source>
        <translation>標的の候補</translation>
    </message>
    <message>
        <source>target refused</source>
        <translation>標的の拒否</translation>
    </message>
    <message>
        <source>no target &apos;%1&apos; is offered</source>
        <translation>候補に標的 &apos;%1&apos; はありません</translation>
    </message>
    <message>
        <source>the target &apos;%1&apos; cannot be taken: %2</source>
        <translation>標的 &apos;%1&apos; を採用できません: %2</translation>
    </message>
    <message>
        <source>is open already</source>
        <translation>既に開かれています</translation>
    </message>
    <message>
        <source>spot that explains the muscle: %1 %2 %3 mm, R2 %4 (logarithm of the MEP; linear %5, log %6)</source>
        <translation>筋の反応を説明する点: %1 %2 %3 mm、R2 %4 (MEP の対数; 線形 %5、対数 %6)</translation>
    </message>
    <message>
        <source>spot that explains the muscle: %1 %2 %3 mm, R2 %4 (straight line of the MEP; linear %5, log %6)</source>
        <translation>筋の反応を説明する点: %1 %2 %3 mm、R2 %4 (MEP の直線; 線形 %5、対数 %6)</translation>
    </message>
    <message>
        <source>logarithm of the</source>
        <translation>対数</translation>
    </message>
    <message>
        <source>straight line of the</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>no sigmoid: the pulses lie on one side of its bend alone; give weaker and stronger ones</source>
        <translation>シグモイドなし: パルスが曲がりの片側にしかありません。弱い刺激と強い刺激を加えてください</translation>
    </message>
    <message>
        <source>no sigmoid: a straight line describes the MEPs&apos; logarithms as well (AICc gain %1, %2 needed)</source>
        <translation>シグモイドなし: 直線でも MEP の対数を同程度に説明できます (AICc の改善 %1、必要 %2)</translation>
    </message>
    <message>
        <source>no sigmoid: a straight line describes the MEPs as well (AICc gain %1, %2 needed)</source>
        <translation>シグモイドなし: 直線でも MEP を同程度に説明できます (AICc の改善 %1、必要 %2)</translation>
    </message>
    <message>
        <source>a sigmoid describes the MEPs&apos; logarithms better than a line: R2 %1 instead of %2, AICc gain %3; its middle lies at %4 V/m at 1 A/us, times the output</source>
        <translation>MEP の対数はシグモイドのほうが直線よりよく説明できます: R2 が %2 から %1 へ、AICc の改善 %3。中点は 1 A/us で %4 V/m、出力倍</translation>
    </message>
    <message>
        <source>a sigmoid describes the MEPs&apos; logarithms better than a line: R2 %1 instead of %2, AICc gain %3; its middle lies at %4 V/m at 1 A/us</source>
        <translation>MEP の対数はシグモイドのほうが直線よりよく説明できます: R2 が %2 から %1 へ、AICc の改善 %3。中点は 1 A/us で %4 V/m</translation>
    </message>
    <message>
        <source>a sigmoid describes the MEPs better than a line: R2 %1 instead of %2, AICc gain %3; its middle lies at %4 V/m at 1 A/us, times the output</source>
        <translation>MEP はシグモイドのほうが直線よりよく説明できます: R2 が %2 から %1 へ、AICc の改善 %3。中点は 1 A/us で %4 V/m、出力倍</translation>
    </message>
    <message>
        <source>a sigmoid describes the MEPs better than a line: R2 %1 instead of %2, AICc gain %3; its middle lies at %4 V/m at 1 A/us</source>
        <translation>MEP はシグモイドのほうが直線よりよく説明できます: R2 が %2 から %1 へ、AICc の改善 %3。中点は 1 A/us で %4 V/m</translation>
    </message>
    <message>
        <source>times the output</source>
        <translation>出力倍</translation>
    </message>
    <message>
        <source>%1 pulses with MEP and pose, regressed on the local field (coil %2, tier %3, at each pulse&apos;s output)</source>
        <translation>MEP と姿勢のあるパルス %1 回を局所の電場に回帰 (コイル %2、段階 %3、各パルスの出力で)</translation>
    </message>
    <message>
        <source>%1 pulses with MEP and pose, regressed on the local field (coil %2, tier %3; no output is known)</source>
        <translation>MEP と姿勢のあるパルス %1 回を局所の電場に回帰 (コイル %2、段階 %3; 出力は不明)</translation>
    </message>
    <message>
        <source>at each pulse&apos;s output</source>
        <translation>各パルスの出力で</translation>
    </message>
    <message>
        <source>no output is known</source>
        <translation>出力は不明</translation>
    </message>
    <message>
        <source>%1 more have an MEP, but no pose or no output: left out</source>
        <translation>ほかに MEP はあるが姿勢または出力のないもの %1 回: 除きました</translation>
    </message>
    <message>
        <source>nothing is explained: no place of the cortex explains the MEPs better than chance</source>
        <translation>説明できる場所がありません: 偶然より MEP をよく説明する皮質の場所がありません</translation>
    </message>
    <message>
        <source>best R2 %1; shuffled MEPs reach it in %2 %</source>
        <translation>最良の R2 %1。並べ替えた MEP でも %2 % がこれに達します</translation>
    </message>
    <message>
        <source>region: 95 % of resampled pulses have their spot within %1 mm, at %2 places</source>
        <translation>領域: パルスの再抽出の 95 % で、点が %1 mm 以内に入ります (%2 か所)</translation>
    </message>
    <message>
        <source>shuffled MEPs reach this R2 in %1 %</source>
        <translation>並べ替えた MEP の %1 % がこの R2 に達します</translation>
    </message>
    <message>
        <source>give its peak-to-peak amplitude in uV, 0 or more</source>
        <translation>ピーク間振幅を uV (0 以上) で入力してください</translation>
    </message>
    <message>
        <source>electric field of the pulses</source>
        <translation>パルスの電場</translation>
    </message>
    <message>
        <source>head and coil tracked</source>
        <translation>頭とコイルを追跡中</translation>
    </message>
    <message>
        <source>lies within 5 mm of the tracker&apos;s origin: are its lengths metres?</source>
        <translation>追跡装置の原点から 5 mm 以内です: 長さの単位がメートルではありませんか?</translation>
    </message>
    <message>
        <source>two tools have the same name at the tracker</source>
        <translation>追跡装置の 2 つのツールが同じ名前です</translation>
    </message>
    <message>
        <source>name the pose of each</source>
        <translation>それぞれの姿勢に名前を付けてください</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 分前</translation>
    </message>
    <message>
        <source>session %1: %2ended %3</source>
        <translation>セッション %1: %2終了 %3</translation>
    </message>
    <message>
        <source>session %1: %2cut off %3</source>
        <translation>セッション %1: %2中断 %3</translation>
    </message>
    <message>
        <source>of %1 pulses</source>
        <translation>(全 %1 パルス)</translation>
    </message>
    <message>
        <source>no face was found in any of %1 frames; check that both cameras see the whole face, upright and lit</source>
        <translation>%1 フレームのどれにも顔が見つかりません。両方のカメラから、正立した明るい顔全体が見えるか確認してください</translation>
    </message>
    <message>
        <source>looking for a face</source>
        <translation>顔を探しています</translation>
    </message>
    <message>
        <source>the recording has no frame</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>both cameras see a face (frame %1), but not where the calibration expects it; check which camera is left, and the calibration</source>
        <translation>両方のカメラから顔が見えます (フレーム %1) が、較正から予想される場所にありません。どちらが左カメラかと、較正を確認してください</translation>
    </message>
    <message>
        <source>case is not aligned and the recording has no capture/ pair to align from</source>
        <translation>症例の位置合わせがなく、記録にも位置合わせに使う capture/ の組がありません</translation>
    </message>
    <message>
        <source>run &apos;facenav align&apos; with a capture first</source>
        <translation>先に撮影したもので &apos;facenav align&apos; を実行してください</translation>
    </message>
    <message>
        <source>the cameras ended before a face was found</source>
        <translation>顔が見つかる前にカメラが終了しました</translation>
    </message>
    <message>
        <source>neither the face nor a marker was found in any of %1 frames: %2</source>
        <translation>%1 フレームのどれにも顔もマーカーも見つかりません: %2</translation>
    </message>
    <message>
        <source>a face was found, but no frame gave a pose that can be trusted (%1); check light, focus and the calibration, or record the face larger and more from the front</source>
        <translation>顔は見つかりましたが、信頼できる姿勢のフレームがありません (%1)。照明、ピント、較正を確認するか、顔をより大きく正面から撮影してください</translation>
    </message>
    <message>
        <source>the root mean square error in millimetres (above 0, at most 50) was expected</source>
        <translation>二乗平均平方根誤差 (mm、0 より大きく 50 以下) が必要です</translation>
    </message>
    <message>
        <source>each point once was expected</source>
        <translation>各点は 1 回ずつ必要です</translation>
    </message>
    <message>
        <source>at least three points were expected</source>
        <translation>3 点以上が必要です</translation>
    </message>
    <message>
        <source>the points do not fit each other (%1 mm rms, %2 expected by error_mm): points are exchanged, or a frame is mirrored or not in millimetres</source>
        <translation>点が互いに合いません (%1 mm rms、error_mm からの予想 %2): 点が入れ替わっているか、座標系が鏡像か、単位が mm ではありません</translation>
    </message>
    <message>
        <source>the touched points fit as well with two of them exchanged (left and right?): touch a point apart from them, such as the vertex</source>
        <translation>触れた点は、2 点を入れ替えても同じように合います (左右の取り違え?): 頭頂など、離れた点にも触れてください</translation>
    </message>
    <message>
        <source>either points or mri_T_subject was expected, not both</source>
        <translation>points か mri_T_subject のどちらか一方が必要です</translation>
    </message>
    <message>
        <source>its point &apos;%1&apos; lies %2 mm from the skin of the case</source>
        <translation>点 &apos;%1&apos; が症例の皮膚から %2 mm 離れています</translation>
    </message>
    <message>
        <source>the tracker&apos;s alignment</source>
        <translation>追跡装置の位置合わせ</translation>
    </message>
    <message>
        <source>is it of this head, and in RAS?</source>
        <translation>この頭部のもので、RAS ですか?</translation>
    </message>
    <message>
        <source>the case is not aligned</source>
        <translation>症例の位置合わせが行われていません</translation>
    </message>
    <message>
        <source>take its pictures first: facenav align CASE --live RIG</source>
        <translation>先に撮影してください: facenav align CASE --live RIG</translation>
    </message>
    <message>
        <source>the case was aligned from a film, which live cameras do not go on from</source>
        <translation>症例の位置合わせは動画から行われており、ライブカメラでは続けられません</translation>
    </message>
    <message>
        <source>align it with a pair: facenav align CASE --live RIG</source>
        <translation>組の画像で位置合わせを行ってください: facenav align CASE --live RIG</translation>
    </message>
    <message>
        <source>the plan is damaged (%1)</source>
        <translation>計画が壊れています (%1)</translation>
    </message>
    <message>
        <source>name the target that you want</source>
        <translation>使う標的を指定してください</translation>
    </message>
    <message>
        <source>%1: on target, %2 mm, %3 deg off</source>
        <translation>%1: 標的上、%2 mm、ずれ %3 deg</translation>
    </message>
    <message>
        <source>%1: adjust, %2 mm, %3 deg off</source>
        <translation>%1: 要調整、%2 mm、ずれ %3 deg</translation>
    </message>
    <message>
        <source>on target</source>
        <translation>標的上</translation>
    </message>
    <message>
        <source>on target, %1 mm, %2 deg off</source>
        <translation>標的上、%1 mm、ずれ %2 deg</translation>
    </message>
    <message>
        <source>adjust, %1 mm, %2 deg off</source>
        <translation>要調整、%1 mm、ずれ %2 deg</translation>
    </message>
    <message>
        <source>%1, version %2: %3 pulses</source>
        <translation>%1、バージョン %2: パルス %3 回</translation>
    </message>
    <message>
        <source>cannot be read, no goal: %1</source>
        <translation>読み込めないため、目標なし: %1</translation>
    </message>
    <message>
        <source>coil calibration</source>
        <translation>コイルの較正</translation>
    </message>
    <message>
        <source>coil focus</source>
        <translation>コイルの焦点</translation>
    </message>
    <message>
        <source>head and coil come from another tracker; its frame stands for the cameras&apos;</source>
        <translation>頭とコイルは別の追跡装置から来ます。その座標系をカメラの座標系として扱います</translation>
    </message>
    <message>
        <source>the coil comes from another tracker</source>
        <translation>コイルは別の追跡装置から来ます</translation>
    </message>
    <message>
        <source>by a file that states its error</source>
        <translation>誤差を記載したファイルによる</translation>
    </message>
    <message>
        <source>%1 mm rms over %2 points</source>
        <translation>%2 点で %1 mm rms</translation>
    </message>
    <message>
        <source>aligned: 95 % within %1 mm at %2 (%3)</source>
        <translation>位置合わせ済み: %2 で 95 % が %1 mm 以内 (%3)</translation>
    </message>
    <message>
        <source>%1: works again</source>
        <translation>%1: 再び動作しています</translation>
    </message>
    <message>
        <source>its copy is not kept: %1</source>
        <translation>その複製は保存されません: %1</translation>
    </message>
    <message>
        <source>%1: no longer listened to</source>
        <translation>%1: もう受信していません</translation>
    </message>
    <message>
        <source>the program was closed</source>
        <translation>プログラムが閉じられました</translation>
    </message>
    <message>
        <source>other coil</source>
        <translation>もう一方のコイル</translation>
    </message>
    <message>
        <source>second coil</source>
        <translation>第 2 コイル</translation>
    </message>
    <message>
        <source>second target</source>
        <translation>第 2 標的</translation>
    </message>
    <message>
        <source>coil of the pulses</source>
        <translation>刺激するコイル</translation>
    </message>
    <message>
        <source>every other source: %1</source>
        <translation>ほかのすべての入力元: %1</translation>
    </message>
    <message>
        <source>there is no coil named &apos;%1&apos;</source>
        <translation>&apos;%1&apos; という名前のコイルはありません</translation>
    </message>
    <message>
        <source>add one with &apos;facenav coil add coil.json&apos;</source>
        <translation>&apos;facenav coil add coil.json&apos; で加えてください</translation>
    </message>
    <message>
        <source>the coil &apos;%1&apos; carries the same marker (%2): a picture cannot tell them apart</source>
        <translation>コイル &apos;%1&apos; のマーカーが同じです (%2): 画像では見分けられません</translation>
    </message>
    <message>
        <source>print another marker for one of them, or remove that coil first</source>
        <translation>どちらかに別のマーカーを印刷するか、先にそのコイルを削除してください</translation>
    </message>
    <message>
        <source>this coil cannot be used: %1</source>
        <translation>このコイルは使えません: %1</translation>
    </message>
    <message>
        <source>give a coil.json, or the name of a coil (facenav coil list)</source>
        <translation>coil.json、またはコイルの名前 (facenav coil list) を指定してください</translation>
    </message>
    <message>
        <source>the coil&apos;s name</source>
        <translation>コイルの名前</translation>
    </message>
    <message>
        <source>the coil has no name</source>
        <translation>コイルに名前がありません</translation>
    </message>
    <message>
        <source>the library has a coil named &apos;%1&apos;</source>
        <translation>ライブラリに &apos;%1&apos; という名前のコイルがあります</translation>
    </message>
    <message>
        <source>give another --name, or --replace</source>
        <translation>別の --name か、--replace を指定してください</translation>
    </message>
    <message>
        <source>cannot be removed (%1)</source>
        <translation>削除できません (%1)</translation>
    </message>
    <message>
        <source>this coil</source>
        <translation>このコイル</translation>
    </message>
    <message>
        <source>(facenav calibrate-coil)</source>
        <translation>(facenav calibrate-coil)</translation>
    </message>
    <message>
        <source>no calibration of %1 is recorded: calibrate it%2</source>
        <translation>%1の較正の記録がありません: 較正してください%2</translation>
    </message>
    <message>
        <source>the calibration of %1 has no date: calibrate it again if it is old%2</source>
        <translation>%1の較正に日付がありません: 古い場合は較正し直してください%2</translation>
    </message>
    <message>
        <source>the calibration of %1 is %2 days old: calibrate it again%3</source>
        <translation>%1の較正から %2 日経っています: 較正し直してください%3</translation>
    </message>
    <message>
        <source>the field of this coil is strongest %1 mm beside its centre: guidance brings the centre to the target</source>
        <translation>このコイルの電場は中心から %1 mm 横で最も強くなります: 誘導は中心を標的に合わせます</translation>
    </message>
    <message>
        <source>the field of %1 is strongest %2 mm beside its centre: guidance brings the centre to the target</source>
        <translation>%1 の電場は中心から %2 mm 横で最も強くなります: 誘導は中心を標的に合わせます</translation>
    </message>
    <message>
        <source>%1: cannot be used, %2</source>
        <translation>%1: 使えません。%2</translation>
    </message>
    <message>
        <source>calibrated %1, residual %2 mm, standard error %3 mm %4 deg</source>
        <translation>較正日 %1、残差 %2 mm、標準誤差 %3 mm %4 deg</translation>
    </message>
    <message>
        <source>(no date)</source>
        <translation>(日付なし)</translation>
    </message>
    <message>
        <source>a winding is matched by 1 to 8 rings in 1 or 2 layers</source>
        <translation>巻線は 1〜2 層、1〜8 個の輪で近似します</translation>
    </message>
    <message>
        <source>figure-8 70 mm (built in)</source>
        <translation>8 の字 70 mm (内蔵)</translation>
    </message>
    <message>
        <source>round 90 mm (built in)</source>
        <translation>円形 90 mm (内蔵)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>&apos;%1&apos; は数値ではありません</translation>
    </message>
    <message>
        <source>copy or export the coil&apos;s file again</source>
        <translation>コイルのファイルをもう一度コピーするか、書き出してください</translation>
    </message>
    <message>
        <source>a dipole needs 6 numbers, this row has %1</source>
        <translation>双極子には 6 個の数値が必要ですが、この行は %1 個です</translation>
    </message>
    <message>
        <source>holds no dipole</source>
        <translation>双極子がありません</translation>
    </message>
    <message>
        <source>choose the coil&apos;s .ccd file</source>
        <translation>コイルの .ccd ファイルを選んでください</translation>
    </message>
    <message>
        <source>announces %1 dipoles and holds %2</source>
        <translation>双極子は %1 個と記載されていますが、%2 個です</translation>
    </message>
    <message>
        <source>the file is not whole: copy it again</source>
        <translation>ファイルが完全ではありません: もう一度コピーしてください</translation>
    </message>
    <message>
        <source>it looks a thousand times too large: write positions in %1, and moments in A m2 for 1 A</source>
        <translation>1000 倍大きすぎるようです: 位置は %1、モーメントは 1 A あたり A m2 で書いてください</translation>
    </message>
    <message>
        <source>it looks a thousand times too small: write positions in %1, and moments in A m2 for 1 A</source>
        <translation>1000 倍小さすぎるようです: 位置は %1、モーメントは 1 A あたり A m2 で書いてください</translation>
    </message>
    <message>
        <source>a coil of %1 mm is no coil for a head</source>
        <translation>%1 mm のコイルは頭部用ではありません</translation>
    </message>
    <message>
        <source>all dipoles are 0: no current flows</source>
        <translation>双極子がすべて 0 です: 電流が流れません</translation>
    </message>
    <message>
        <source>check the coil&apos;s file</source>
        <translation>コイルのファイルを確認してください</translation>
    </message>
    <message>
        <source>moments of %1 A m2 for 1 A are no coil&apos;s</source>
        <translation>1 A あたり %1 A m2 のモーメントはコイルのものではありません</translation>
    </message>
    <message>
        <source>the coil&apos;s field holds a value that is no number</source>
        <translation>コイルの電場に数値でない値があります</translation>
    </message>
    <message>
        <source>a coil&apos;s field sampled over %1 mm is none for a head</source>
        <translation>%1 mm にわたって標本化されたコイルの電場は頭部用ではありません</translation>
    </message>
    <message>
        <source>the grid must be in mm: check whether metres and mm are exchanged</source>
        <translation>格子の単位は mm でなければなりません: メートルと mm を取り違えていないか確認してください</translation>
    </message>
    <message>
        <source>a vector potential of %1 T m for 1 A is no coil&apos;s</source>
        <translation>1 A あたり %1 T m のベクトルポテンシャルはコイルのものではありません</translation>
    </message>
    <message>
        <source>the values must be T m per ampere: check the file&apos;s units</source>
        <translation>値は 1 アンペアあたり T m でなければなりません: ファイルの単位を確認してください</translation>
    </message>
    <message>
        <source>sform and qform of the coil&apos;s grid differ by up to %1 mm: the %2 is used, as SimNIBS does</source>
        <translation>コイルの格子の sform と qform が最大 %1 mm 異なります: SimNIBS と同じく %2 を使います</translation>
    </message>
    <message>
        <source>no such coil</source>
        <translation>そのコイルはありません</translation>
    </message>
    <message>
        <source>give figure8-70, round, or a .ccd, .tcd or .nii.gz file</source>
        <translation>figure8-70、round、または .ccd、.tcd、.nii.gz ファイルを指定してください</translation>
    </message>
    <message>
        <source>is no coil&apos;s field by its name</source>
        <translation>名前から見てコイルの電場ではありません</translation>
    </message>
    <message>
        <source>give a .ccd, .tcd, .nii or .nii.gz file</source>
        <translation>.ccd、.tcd、.nii、.nii.gz ファイルのいずれかを指定してください</translation>
    </message>
    <message>
        <source>holds no part that carries current</source>
        <translation>電流の流れる部分がありません</translation>
    </message>
    <message>
        <source>choose another file of the coil</source>
        <translation>コイルの別のファイルを選んでください</translation>
    </message>
    <message>
        <source>a largest rate of the current of %1 A/us is no stimulator&apos;s</source>
        <translation>最大電流変化率 %1 A/us は刺激装置のものではありません</translation>
    </message>
    <message>
        <source>dIdtmax is in A/us, maxdIdt in A/s</source>
        <translation>dIdtmax の単位は A/us、maxdIdt は A/s です</translation>
    </message>
    <message>
        <source>the coil&apos;s field grows with the distance from the contact face</source>
        <translation>コイルの電場が接触面から離れるほど強くなっています</translation>
    </message>
    <message>
        <source>check the file&apos;s frame: the coil lies at z &lt; 0, z points into the head</source>
        <translation>ファイルの座標系を確認してください: コイルは z &lt; 0、z は頭の中へ向きます</translation>
    </message>
    <message>
        <source>the coil&apos;s field is not sampled 8 to 14 mm below the contact face (z = 0)</source>
        <translation>コイルの電場が接触面 (z = 0) の下 8〜14 mm で標本化されていません</translation>
    </message>
    <message>
        <source>use the coil&apos;s .ccd or .tcd file</source>
        <translation>コイルの .ccd または .tcd ファイルを使ってください</translation>
    </message>
    <message>
        <source>the coil&apos;s field has no magnetic flux below the contact face</source>
        <translation>コイルの電場の磁束が接触面の下にありません</translation>
    </message>
    <message>
        <source>check the file</source>
        <translation>ファイルを確認してください</translation>
    </message>
    <message>
        <source>the coil&apos;s field below the contact face is not that of a coil behind it (%1 % are left)</source>
        <translation>接触面の下のコイルの電場が、その後ろのコイルのものではありません (残り %1 %)</translation>
    </message>
    <message>
        <source>use the coil&apos;s .ccd or .tcd file, and check that z points into the head</source>
        <translation>コイルの .ccd または .tcd ファイルを使い、z が頭の中へ向いているか確認してください</translation>
    </message>
    <message>
        <source>is no base64 of three numbers a point</source>
        <translation>1 点あたり 3 個の数値の base64 ではありません</translation>
    </message>
    <message>
        <source>four rows of four numbers were expected</source>
        <translation>4 個の数値の行が 4 行必要です</translation>
    </message>
    <message>
        <source>names a range that is not there</source>
        <translation>存在しない範囲を示しています</translation>
    </message>
    <message>
        <source>a move of type x, y, z or rot2p was expected</source>
        <translation>種類 x、y、z、rot2p の移動が必要です</translation>
    </message>
    <message>
        <source>turns about an axis without length</source>
        <translation>長さのない軸のまわりに回転しています</translation>
    </message>
    <message>
        <source>names a move that is not there</source>
        <translation>存在しない移動を示しています</translation>
    </message>
    <message>
        <source>the sampled field is packed in a form that only Python reads: save the coil as text (ascii mode)</source>
        <translation>標本化した電場が Python でしか読めない形式です: コイルをテキスト (ascii モード) で保存してください</translation>
    </message>
    <message>
        <source>the sampled field is empty</source>
        <translation>標本化した電場が空です</translation>
    </message>
    <message>
        <source>the sampled field is no full block</source>
        <translation>標本化した電場が完全な直方体ではありません</translation>
    </message>
    <message>
        <source>a type of 1, 2 or 3 was expected</source>
        <translation>種類 1、2、3 のいずれかが必要です</translation>
    </message>
    <message>
        <source>has not as many values as points</source>
        <translation>値の数が点の数と合いません</translation>
    </message>
    <message>
        <source>the coil has several stimulators: all parts are taken with the same current</source>
        <translation>コイルに複数の刺激装置があります: すべての部分に同じ電流を流すものとします</translation>
    </message>
    <message>
        <source>the coil has movable parts: they are taken as the file places them at first</source>
        <translation>コイルに動く部分があります: ファイルの最初の配置で扱います</translation>
    </message>
    <message>
        <source>the equations of the head model have no unique solution</source>
        <translation>頭部モデルの方程式の解が 1 つに定まりません</translation>
    </message>
    <message>
        <source>the mesh holds no field named E or magnE</source>
        <translation>メッシュに E または magnE という電場がありません</translation>
    </message>
    <message>
        <source>export the field with the mesh</source>
        <translation>電場をメッシュとともに書き出してください</translation>
    </message>
    <message>
        <source>the mesh has an element of a node that is not there</source>
        <translation>メッシュに、存在しない節点の要素があります</translation>
    </message>
    <message>
        <source>export the field again</source>
        <translation>電場を書き出し直してください</translation>
    </message>
    <message>
        <source>the mesh holds no value of the field on the grey matter</source>
        <translation>メッシュの灰白質に電場の値がありません</translation>
    </message>
    <message>
        <source>no sphere of a head&apos;s size fits the surface under the coil</source>
        <translation>コイルの下の表面に合う、頭部の大きさの球がありません</translation>
    </message>
    <message>
        <source>check the target&apos;s pose and the case&apos;s surfaces</source>
        <translation>標的の姿勢と症例の表面を確認してください</translation>
    </message>
    <message>
        <source>electric field: equations</source>
        <translation>電場: 方程式</translation>
    </message>
    <message>
        <source>outer skull</source>
        <translation>頭蓋骨外面</translation>
    </message>
    <message>
        <source>inner skull</source>
        <translation>頭蓋骨内面</translation>
    </message>
    <message>
        <source>electric field: solving</source>
        <translation>電場: 求解</translation>
    </message>
    <message>
        <source>correct the brain mask, or prepare the case again</source>
        <translation>脳マスクを修正するか、症例を準備し直してください</translation>
    </message>
    <message>
        <source>the case&apos;s cortex lies outside the brain mask</source>
        <translation>症例の皮質が脳マスクの外にあります</translation>
    </message>
    <message>
        <source>the brain comes nearer than 1 mm to the skull</source>
        <translation>脳と頭蓋骨の距離が 1 mm 未満です</translation>
    </message>
    <message>
        <source>the case&apos;s cortex gives no closed surface</source>
        <translation>症例の皮質から閉じた表面を作れません</translation>
    </message>
    <message>
        <source>the case has no brain mask</source>
        <translation>症例に脳マスクがありません</translation>
    </message>
    <message>
        <source>the brain mask consists of several parts</source>
        <translation>脳マスクが複数の部分に分かれています</translation>
    </message>
    <message>
        <source>the brain mask has large holes or gaps</source>
        <translation>脳マスクに大きな穴または隙間があります</translation>
    </message>
    <message>
        <source>the scan&apos;s border cuts the brain</source>
        <translation>脳がスキャンの端で切れています</translation>
    </message>
    <message>
        <source>take a scan of the whole head</source>
        <translation>頭部全体のスキャンを使ってください</translation>
    </message>
    <message>
        <source>the scan&apos;s border cuts the head beside the brain</source>
        <translation>脳の横の頭がスキャンの端で切れています</translation>
    </message>
    <message>
        <source>the brain mask reaches the skin</source>
        <translation>脳マスクが皮膚に達しています</translation>
    </message>
    <message>
        <source>the surfaces of skull and skin come nearer than 2 mm to each other</source>
        <translation>頭蓋骨と皮膚の表面の距離が 2 mm 未満です</translation>
    </message>
    <message>
        <source>the surface &apos;%1&apos; is not closed</source>
        <translation>表面 &apos;%1&apos; が閉じていません</translation>
    </message>
    <message>
        <source>the electric field needs a closed one</source>
        <translation>電場には閉じた表面が必要です</translation>
    </message>
    <message>
        <source>the triangles of the surface &apos;%1&apos; face inwards</source>
        <translation>表面 &apos;%1&apos; の三角形が内側を向いています</translation>
    </message>
    <message>
        <source>reverse their corners</source>
        <translation>頂点の順序を逆にしてください</translation>
    </message>
    <message>
        <source>FaceNav field 1</source>
        <translation>FaceNav field 1</translation>
    </message>
    <message>
        <source>compute the field again</source>
        <translation>電場を計算し直してください</translation>
    </message>
    <message>
        <source>the file of the electric field is damaged</source>
        <translation>電場のファイルが壊れています</translation>
    </message>
    <message>
        <source>the file of the electric field cannot be read</source>
        <translation>電場のファイルを読み込めません</translation>
    </message>
    <message>
        <source>the electric field was computed for another head model</source>
        <translation>電場が別の頭部モデルで計算されています</translation>
    </message>
    <message>
        <source>electric field: modes</source>
        <translation>電場: モード</translation>
    </message>
    <message>
        <source>the cortex has no points</source>
        <translation>皮質に点がありません</translation>
    </message>
    <message>
        <source>holds a word where a number was expected</source>
        <translation>数値が必要な場所に文字があります</translation>
    </message>
    <message>
        <source>announces an impossible number of entries</source>
        <translation>項目数の記載があり得ない値です</translation>
    </message>
    <message>
        <source>the mesh %1</source>
        <translation>メッシュ: %1</translation>
    </message>
    <message>
        <source>is not of gmsh&apos;s format 2</source>
        <translation>gmsh の形式 2 ではありません</translation>
    </message>
    <message>
        <source>holds numbers of another size than 8 bytes</source>
        <translation>数値の大きさが 8 バイトではありません</translation>
    </message>
    <message>
        <source>has the byte order of another machine</source>
        <translation>別の機械のバイト順です</translation>
    </message>
    <message>
        <source>holds elements of an unknown kind</source>
        <translation>不明な種類の要素があります</translation>
    </message>
    <message>
        <source>holds data of an unknown kind</source>
        <translation>不明な種類のデータがあります</translation>
    </message>
    <message>
        <source>does not begin as a gmsh file</source>
        <translation>gmsh ファイルの先頭ではありません</translation>
    </message>
    <message>
        <source>is no gmsh file</source>
        <translation>gmsh ファイルではありません</translation>
    </message>
    <message>
        <source>the %1 measures %2 mm; no head does</source>
        <translation>%1の計測値が %2 mm です。頭部としてあり得ません</translation>
    </message>
    <message>
        <source>check the landmarks</source>
        <translation>ランドマークを確認してください</translation>
    </message>
    <message>
        <source>way from nasion to inion</source>
        <translation>鼻根点から後頭結節までの経路</translation>
    </message>
    <message>
        <source>way from tragus to tragus</source>
        <translation>耳珠から耳珠までの経路</translation>
    </message>
    <message>
        <source>beside the coil the cameras see the surface %1 mm outside the MRI&apos;s skin (error %2): hair, or the alignment is off</source>
        <translation>コイルの横で、カメラから見える表面が MRI の皮膚より %1 mm 外側です (誤差 %2): 髪、または位置合わせのずれ</translation>
    </message>
    <message>
        <source>beside the coil the cameras see the surface %1 mm outside the MRI&apos;s skin (error %2): the alignment is off, or something presses the skin</source>
        <translation>コイルの横で、カメラから見える表面が MRI の皮膚より %1 mm 外側です (誤差 %2): 位置合わせのずれ、または皮膚の圧迫</translation>
    </message>
    <message>
        <source>beside the coil the cameras see the surface %1 mm inside the MRI&apos;s skin (error %2): hair, or the alignment is off</source>
        <translation>コイルの横で、カメラから見える表面が MRI の皮膚より %1 mm 内側です (誤差 %2): 髪、または位置合わせのずれ</translation>
    </message>
    <message>
        <source>beside the coil the cameras see the surface %1 mm inside the MRI&apos;s skin (error %2): the alignment is off, or something presses the skin</source>
        <translation>コイルの横で、カメラから見える表面が MRI の皮膚より %1 mm 内側です (誤差 %2): 位置合わせのずれ、または皮膚の圧迫</translation>
    </message>
    <message>
        <source>the coil&apos;s axis meets no skin</source>
        <translation>コイルの軸が皮膚に当たりません</translation>
    </message>
    <message>
        <source>choose another place or direction</source>
        <translation>別の場所か向きを選んでください</translation>
    </message>
    <message>
        <source>a corner within 300 mm of the coil&apos;s centre was expected</source>
        <translation>コイル中心から 300 mm 以内の角が必要です</translation>
    </message>
    <message>
        <source>three corners at least were expected</source>
        <translation>3 つ以上の角が必要です</translation>
    </message>
    <message>
        <source>the outline was expected to surround the coil&apos;s centre [0, 0]</source>
        <translation>輪郭はコイル中心 [0, 0] を囲まなければなりません</translation>
    </message>
    <message>
        <source>%1 is %2; %3 to %4 was expected</source>
        <translation>%1 が %2 です。%3〜%4 が必要です</translation>
    </message>
    <message>
        <source>check the protocol</source>
        <translation>プロトコルを確認してください</translation>
    </message>
    <message>
        <source>no more than there are pulses</source>
        <translation>パルスの数以下にしてください</translation>
    </message>
    <message>
        <source>there is no EEG site &apos;%1&apos;</source>
        <translation>脳波電極位置 &apos;%1&apos; はありません</translation>
    </message>
    <message>
        <source>no hand area can be guessed: the brain is empty</source>
        <translation>手の領域を推定できません: 脳が空です</translation>
    </message>
    <message>
        <source>a handle angle lies between -180 and 180 degrees</source>
        <translation>ハンドルの角度は -180〜180 度です</translation>
    </message>
    <message>
        <source>0 points straight back</source>
        <translation>0 は真後ろです</translation>
    </message>
    <message>
        <source>a gap for hair lies between 0 and %1 mm</source>
        <translation>髪のための隙間は 0〜%1 mm です</translation>
    </message>
    <message>
        <source>measure it on the patient</source>
        <translation>患者で測ってください</translation>
    </message>
    <message>
        <source>the scalp ends there</source>
        <translation>頭皮がそこで途切れています</translation>
    </message>
    <message>
        <source>move it less far</source>
        <translation>移動量を減らしてください</translation>
    </message>
    <message>
        <source>to the patient&apos;s right</source>
        <translation>患者の右へ</translation>
    </message>
    <message>
        <source>to the patient&apos;s left</source>
        <translation>患者の左へ</translation>
    </message>
    <message>
        <source>towards the face</source>
        <translation>顔の方へ</translation>
    </message>
    <message>
        <source>towards the back of the head</source>
        <translation>後頭部の方へ</translation>
    </message>
    <message>
        <source>up, towards the top of the head</source>
        <translation>上、頭頂の方へ</translation>
    </message>
    <message>
        <source>down, towards the neck</source>
        <translation>下、首の方へ</translation>
    </message>
    <message>
        <source>move %1 mm %2</source>
        <translation>%2 %1 mm 動かす</translation>
    </message>
    <message>
        <source>tilt the handle side up %1</source>
        <translation>ハンドル側を %1 上げる</translation>
    </message>
    <message>
        <source>tilt the handle side down %1</source>
        <translation>ハンドル側を %1 下げる</translation>
    </message>
    <message>
        <source>tilt the left wing up %1</source>
        <translation>コイルの左側を %1 上げる</translation>
    </message>
    <message>
        <source>tilt the left wing down %1</source>
        <translation>コイルの左側を %1 下げる</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>lift the coil %1</source>
        <translation>コイルを %1 離す</translation>
    </message>
    <message>
        <source>press %1 closer</source>
        <translation>%1 近づける</translation>
    </message>
    <message>
        <source>turn counterclockwise seen from above the coil %1</source>
        <translation>コイルの上から見て反時計回りに %1 回す</translation>
    </message>
    <message>
        <source>turn clockwise seen from above the coil %1</source>
        <translation>コイルの上から見て時計回りに %1 回す</translation>
    </message>
    <message>
        <source>lost: the face is not seen</source>
        <translation>追跡喪失: 顔が見えません</translation>
    </message>
    <message>
        <source>lost: too little of the face is seen</source>
        <translation>追跡喪失: 顔の見える範囲が足りません</translation>
    </message>
    <message>
        <source>lost: the coil&apos;s marker is not seen</source>
        <translation>追跡喪失: コイルのマーカーが見えません</translation>
    </message>
    <message>
        <source>lost: the face does not fit the cameras&apos; views</source>
        <translation>追跡喪失: 顔が両カメラの画像と合いません</translation>
    </message>
    <message>
        <source>lost: the marker does not fit the cameras&apos; views</source>
        <translation>追跡喪失: マーカーが両カメラの画像と合いません</translation>
    </message>
    <message>
        <source>lost: no picture from the cameras</source>
        <translation>追跡喪失: カメラの画像がありません</translation>
    </message>
    <message>
        <source>lost: the picture is too old</source>
        <translation>追跡喪失: 画像が古すぎます</translation>
    </message>
    <message>
        <source>no target can be planned: the scalp surface is empty</source>
        <translation>標的を計画できません: 頭皮の表面が空です</translation>
    </message>
    <message>
        <source>no target can be planned: the cortex point lies %1 mm from the scalp</source>
        <translation>標的を計画できません: 皮質の点が頭皮から %1 mm 離れています</translation>
    </message>
    <message>
        <source>choose a point on the cortex</source>
        <translation>皮質上の点を選んでください</translation>
    </message>
    <message>
        <source>a grid of %1 x %2 cannot be made</source>
        <translation>%1 x %2 の格子は作れません</translation>
    </message>
    <message>
        <source>give 1 to 15 rows and columns, and two places at least</source>
        <translation>行と列を 1〜15、合計 2 か所以上で指定してください</translation>
    </message>
    <message>
        <source>a spacing of %1 mm cannot be used</source>
        <translation>間隔 %1 mm は使えません</translation>
    </message>
    <message>
        <source>give 1 to 30 mm</source>
        <translation>1〜30 mm で指定してください</translation>
    </message>
    <message>
        <source>&quot;scalp&quot; or &quot;cortex&quot; was expected</source>
        <translation>&quot;scalp&quot; か &quot;cortex&quot; が必要です</translation>
    </message>
    <message>
        <source>the plan is damaged, what can be read of it is used: %1</source>
        <translation>計画が壊れています。読める部分を使います: %1</translation>
    </message>
    <message>
        <source>there is no target named &apos;%1&apos;%2</source>
        <translation>&apos;%1&apos; という標的はありません%2</translation>
    </message>
    <message>
        <source>plan a target first</source>
        <translation>先に標的を計画してください</translation>
    </message>
    <message>
        <source>the target&apos;s name</source>
        <translation>標的の名前</translation>
    </message>
    <message>
        <source>the target &apos;%1&apos; cannot be kept: %2</source>
        <translation>標的 &apos;%1&apos; を残せません: %2</translation>
    </message>
    <message>
        <source>check what was typed</source>
        <translation>入力した内容を確認してください</translation>
    </message>
    <message>
        <source>its pose is no place near the head</source>
        <translation>姿勢が頭部の近くではありません</translation>
    </message>
    <message>
        <source>its points are no places near the head</source>
        <translation>点が頭部の近くではありません</translation>
    </message>
    <message>
        <source>its lift is no height</source>
        <translation>持ち上げ量が高さとして正しくありません</translation>
    </message>
    <message>
        <source>the note of the target &apos;%1&apos;</source>
        <translation>標的 &apos;%1&apos; のメモ</translation>
    </message>
    <message>
        <source>its grid has no spacing</source>
        <translation>格子の間隔がありません</translation>
    </message>
    <message>
        <source>the spread of its pulses is no number</source>
        <translation>パルスのばらつきが数値ではありません</translation>
    </message>
    <message>
        <source>two targets have the same name</source>
        <translation>同じ名前の標的が 2 つあります</translation>
    </message>
    <message>
        <source>a target is left out: %1</source>
        <translation>標的を 1 つ除きます: %1</translation>
    </message>
    <message>
        <source>%1 mm inside the skin</source>
        <translation>皮膚の %1 mm 内側</translation>
    </message>
    <message>
        <source>%1 mm outside the skin</source>
        <translation>皮膚の %1 mm 外側</translation>
    </message>
    <message>
        <source>%1 pulses with MEP and pose are too few for a map by field</source>
        <translation>MEP と姿勢のあるパルスが %1 回では、電場によるマップには足りません</translation>
    </message>
    <message>
        <source>at least %1 are needed, with the coil held in many ways</source>
        <translation>コイルの持ち方をさまざまに変えて、%1 回以上必要です</translation>
    </message>
    <message>
        <source>all MEPs are equal, so no place can explain them</source>
        <translation>MEP がすべて等しく、説明できる場所がありません</translation>
    </message>
    <message>
        <source>enter the measured MEPs</source>
        <translation>測定した MEP を入力してください</translation>
    </message>
    <message>
        <source>at %1 %: %2 with a response, %3 without</source>
        <translation>%1 % で: 反応あり %2、反応なし %3</translation>
    </message>
    <message>
        <source>too few pulses for a curve of the response</source>
        <translation>反応の曲線にはパルスが足りません</translation>
    </message>
    <message>
        <source>all pulses had the same field at the spot</source>
        <translation>その点ではすべてのパルスの電場が同じです</translation>
    </message>
    <message>
        <source>unknown threshold method &apos;%1&apos;</source>
        <translation>閾値の求め方 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>choose bayes or 5of10</source>
        <translation>bayes か 5of10 を選んでください</translation>
    </message>
    <message>
        <source>an intensity of %1 % is not possible</source>
        <translation>強度 %1 % はあり得ません</translation>
    </message>
    <message>
        <source>give 0 to 100 % of the maximal output</source>
        <translation>最大出力に対する 0〜100 % で入力してください</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>まだ不明</translation>
    </message>
    <message>
        <source>not found up to 100 %</source>
        <translation>100 % までに見つかりません</translation>
    </message>
    <message>
        <source>%1 % or less</source>
        <translation>%1 % 以下</translation>
    </message>
    <message>
        <source>(95 % interval %1 to %2)</source>
        <translation>(95 % 区間 %1〜%2)</translation>
    </message>
    <message>
        <source>%1, %2, %3 response of %4 pulse</source>
        <translation>%1、%2、%4 パルス中 %3 で反応</translation>
    </message>
    <message>
        <source>%1, %2, %3 response of %4 pulses</source>
        <translation>%1、%2、%4 パルス中 %3 で反応</translation>
    </message>
    <message>
        <source>%1, %2, %3 responses of %4 pulse</source>
        <translation>%1、%2、%4 パルス中 %3 で反応</translation>
    </message>
    <message>
        <source>%1, %2, %3 responses of %4 pulses</source>
        <translation>%1、%2、%4 パルス中 %3 で反応</translation>
    </message>
    <message>
        <source>coil&apos;s marker and jig are seen together in only %1 frames that agree</source>
        <translation>コイルのマーカーと治具がともに見えて一致したフレームが %1 枚だけです</translation>
    </message>
    <message>
        <source>show both to both cameras, from several directions</source>
        <translation>両方を、いろいろな方向から両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>the marker is seen in only %1 frames of the pivoting</source>
        <translation>ピボット中にマーカーが見えたフレームが %1 枚だけです</translation>
    </message>
    <message>
        <source>turn the coil about its tip for some seconds, marker towards the cameras</source>
        <translation>マーカーをカメラに向けたまま、先端のまわりにコイルを数秒間回してください</translation>
    </message>
    <message>
        <source>the coil was hardly turned while it was pivoted</source>
        <translation>ピボット中のコイルの回転が足りません</translation>
    </message>
    <message>
        <source>tilt it by 30 degrees and more to the sides and back and forth</source>
        <translation>左右と前後に 30 度以上傾けてください</translation>
    </message>
    <message>
        <source>centre, handle and side of the coil lie too near to each other or in one line</source>
        <translation>コイルの中心、ハンドル、側面の点が近すぎるか、一直線上にあります</translation>
    </message>
    <message>
        <source>choose points at least 20 mm apart</source>
        <translation>20 mm 以上離れた点を選んでください</translation>
    </message>
    <message>
        <source>a place within 200 mm of the coil&apos;s centre was expected</source>
        <translation>コイル中心から 200 mm 以内の場所が必要です</translation>
    </message>
    <message>
        <source>the coil &apos;%1&apos; carries the same marker as &apos;%2&apos; (%3): a picture cannot tell them apart</source>
        <translation>コイル &apos;%1&apos; と &apos;%2&apos; のマーカーが同じです (%3): 画像では見分けられません</translation>
    </message>
    <message>
        <source>print another marker for one of them</source>
        <translation>どちらかに別のマーカーを印刷してください</translation>
    </message>
    <message>
        <source>two coils need two names, not &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>2 つのコイルには 2 つの名前が必要です (&apos;%1&apos; と &apos;%2&apos;)</translation>
    </message>
    <message>
        <source>give one another name in its coil.json</source>
        <translation>どちらかの coil.json で別の名前を付けてください</translation>
    </message>
    <message>
        <source>the edge of the black square in millimetres (5 to 1000) was expected</source>
        <translation>黒い正方形の一辺 (mm、5〜1000) が必要です</translation>
    </message>
    <message>
        <source>how well the size is known, in millimetres, was expected (above 0)</source>
        <translation>大きさの確かさ (mm、0 より大きい値) が必要です</translation>
    </message>
    <message>
        <source>at least one marker was expected</source>
        <translation>マーカーが 1 つ以上必要です</translation>
    </message>
    <message>
        <source>the same marker is given twice, so the one that is seen cannot be identified</source>
        <translation>同じマーカーが 2 回指定されており、見えたものを識別できません</translation>
    </message>
    <message>
        <source>a tip at most 500 mm from the coil&apos;s centre was expected</source>
        <translation>コイル中心から 500 mm 以内の先端が必要です</translation>
    </message>
    <message>
        <source>one 60 mm marker</source>
        <translation>60 mm のマーカー 1 つ</translation>
    </message>
    <message>
        <source>the coil has no marker</source>
        <translation>コイルにマーカーがありません</translation>
    </message>
    <message>
        <source>give one in coil.json</source>
        <translation>coil.json で指定してください</translation>
    </message>
    <message>
        <source>%1, black square %2 mm</source>
        <translation>%1、黒い正方形 %2 mm</translation>
    </message>
    <message>
        <source>100 mm: print at 100 %, measure this line and the black squares, put the measured size into coil.json</source>
        <translation>100 mm: print at 100 %, measure this line and the black squares, put the measured size into coil.json</translation>
    </message>
    <message>
        <source>the markers do not fit on an A4 page</source>
        <translation>マーカーが A4 の 1 ページに収まりません</translation>
    </message>
    <message>
        <source>make a page for fewer or smaller ones</source>
        <translation>数を減らすか小さくしたページを作ってください</translation>
    </message>
    <message>
        <source>marker id %1 is not in dictionary %2</source>
        <translation>マーカー id %1 は辞書 %2 にありません</translation>
    </message>
    <message>
        <source>choose 0 to %1</source>
        <translation>0〜%1 から選んでください</translation>
    </message>
    <message>
        <source>is no ARToolKit pattern (4 x 3 x 16 x 16 numbers were expected)</source>
        <translation>ARToolKit のパターンではありません (4 x 3 x 16 x 16 個の数値が必要です)</translation>
    </message>
    <message>
        <source>is no ARToolKit pattern (a number outside 0..255)</source>
        <translation>ARToolKit のパターンではありません (0..255 の範囲外の数値)</translation>
    </message>
    <message>
        <source>holds no pattern (it is all of one grey)</source>
        <translation>パターンがありません (全体が同じグレーです)</translation>
    </message>
    <message>
        <source>no face is found in both images of the reference frame</source>
        <translation>基準フレームの両方の画像に顔が見つかりません</translation>
    </message>
    <message>
        <source>turn the face towards the cameras and light it evenly</source>
        <translation>顔をカメラに向け、むらなく照らしてください</translation>
    </message>
    <message>
        <source>no face with enough texture and depth is found in the reference frame</source>
        <translation>基準フレームに、模様と奥行きの十分な顔が見つかりません</translation>
    </message>
    <message>
        <source>look for blur, darkness or a covered face</source>
        <translation>ぶれ、暗さ、顔の覆いがないか確認してください</translation>
    </message>
    <message>
        <source>the host &apos;%1&apos; is not known</source>
        <translation>ホスト &apos;%1&apos; が見つかりません</translation>
    </message>
    <message>
        <source>give its address, 192.168.0.5</source>
        <translation>アドレスを入力してください (例: 192.168.0.5)</translation>
    </message>
    <message>
        <source>cannot be sent to</source>
        <translation>送信できません</translation>
    </message>
    <message>
        <source>check the network</source>
        <translation>ネットワークを確認してください</translation>
    </message>
    <message>
        <source>has a quaternion of length %1</source>
        <translation>四元数の長さが %1 です</translation>
    </message>
    <message>
        <source>holds numbers that are not finite</source>
        <translation>有限でない数値があります</translation>
    </message>
    <message>
        <source>is mirrored</source>
        <translation>鏡像です</translation>
    </message>
    <message>
        <source>is scaled by %1 (a rotation and millimetres are expected)</source>
        <translation>%1 倍に拡大縮小されています (回転とミリメートルが必要です)</translation>
    </message>
    <message>
        <source>is sheared</source>
        <translation>歪んでいます</translation>
    </message>
    <message>
        <source>unknown tracker &apos;%1&apos;</source>
        <translation>追跡装置 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>the server is not connected</source>
        <translation>サーバーに接続していません</translation>
    </message>
    <message>
        <source>the server has sent no pose of this name</source>
        <translation>サーバーからこの名前の姿勢が送られていません</translation>
    </message>
    <message>
        <source>no new message for %1 s</source>
        <translation>%1 s 間、新しいメッセージがありません</translation>
    </message>
    <message>
        <source>no event can be made</source>
        <translation>イベントを作成できません</translation>
    </message>
    <message>
        <source>commands are not accepted</source>
        <translation>命令は受け付けません</translation>
    </message>
    <message>
        <source>unknown command: start, stop, pulse and pulse COIL are taken</source>
        <translation>不明な命令: start、stop、pulse、pulse COIL を受け付けます</translation>
    </message>
    <message>
        <source>targets are not accepted</source>
        <translation>標的は受け付けません</translation>
    </message>
    <message>
        <source>unknown word &apos;%1&apos; of --accept</source>
        <translation>--accept の語 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>give targets, commands or targets,commands</source>
        <translation>targets、commands、または targets,commands を指定してください</translation>
    </message>
    <message>
        <source>has gone</source>
        <translation>接続が切れました</translation>
    </message>
    <message>
        <source>does not speak OpenIGTLink</source>
        <translation>OpenIGTLink で通信していません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no address</source>
        <translation>&apos;%1&apos; はアドレスではありません</translation>
    </message>
    <message>
        <source>give it as numbers, 192.168.0.5</source>
        <translation>数字で指定してください (例: 192.168.0.5)</translation>
    </message>
    <message>
        <source>cannot be served on port %1 (%2)</source>
        <translation>ポート %1 で配信できません (%2)</translation>
    </message>
    <message>
        <source>choose another port, or end the program that uses it</source>
        <translation>別のポートを選ぶか、それを使っているプログラムを終了してください</translation>
    </message>
    <message>
        <source>ask again</source>
        <translation>もう一度問い合わせてください</translation>
    </message>
    <message>
        <source>no frame yet</source>
        <translation>まだフレームがありません</translation>
    </message>
    <message>
        <source>an image of %1 voxels along an axis cannot be sent</source>
        <translation>1 方向に %1 ボクセルの画像は送信できません</translation>
    </message>
    <message>
        <source>unknown output &apos;%1&apos;</source>
        <translation>出力 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>igtl[:[ADDRESS:]PORT], osc:[HOST:]PORT, json:[HOST:]PORT, lsl[:STREAM], invesalius:[HOST:]PORT[:robot=ADDRESS]</source>
        <translation>igtl[:[ADDRESS:]PORT], osc:[HOST:]PORT, json:[HOST:]PORT, lsl[:STREAM], invesalius:[HOST:]PORT[:robot=ADDRESS]</translation>
    </message>
    <message>
        <source>LSL made no stream</source>
        <translation>LSL がストリームを作成できませんでした</translation>
    </message>
    <message>
        <source>check liblsl</source>
        <translation>liblsl を確認してください</translation>
    </message>
    <message>
        <source>LSL opened no stream</source>
        <translation>LSL がストリームを開けませんでした</translation>
    </message>
    <message>
        <source>check liblsl and the network</source>
        <translation>liblsl とネットワークを確認してください</translation>
    </message>
    <message>
        <source>stream %1, listened to</source>
        <translation>ストリーム %1、受信者あり</translation>
    </message>
    <message>
        <source>stream %1, nobody listens</source>
        <translation>ストリーム %1、受信者なし</translation>
    </message>
    <message>
        <source>does not answer as a relay</source>
        <translation>中継サーバーとして応答しません</translation>
    </message>
    <message>
        <source>is silent</source>
        <translation>応答がありません</translation>
    </message>
    <message>
        <source>takes nothing</source>
        <translation>何も受け付けません</translation>
    </message>
    <message>
        <source>is not there</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>has closed</source>
        <translation>閉じられました</translation>
    </message>
    <message>
        <source>refuses clients</source>
        <translation>接続を拒否しています</translation>
    </message>
    <message>
        <source>the relay %1</source>
        <translation>中継サーバー: %1</translation>
    </message>
    <message>
        <source>From Neuronavigation</source>
        <translation>From Neuronavigation</translation>
    </message>
    <message>
        <source>Neuronavigation to Robot</source>
        <translation>Neuronavigation to Robot</translation>
    </message>
    <message>
        <source>Robot to Neuronavigation</source>
        <translation>Robot to Neuronavigation</translation>
    </message>
    <message>
        <source>follows the target</source>
        <translation>標的に追従</translation>
    </message>
    <message>
        <source>moves away from the head</source>
        <translation>頭から離れる</translation>
    </message>
    <message>
        <source>%1Update tracker poses</source>
        <translation>%1Update tracker poses</translation>
    </message>
    <message>
        <source>%1Send coil pose</source>
        <translation>%1Send coil pose</translation>
    </message>
    <message>
        <source>%1Coil at target</source>
        <translation>%1Coil at target</translation>
    </message>
    <message>
        <source>%1Update displacement to target</source>
        <translation>%1Update displacement to target</translation>
    </message>
    <message>
        <source>%1Set target</source>
        <translation>%1Set target</translation>
    </message>
    <message>
        <source>%1Unset target</source>
        <translation>%1Unset target</translation>
    </message>
    <message>
        <source>%1Connect to robot</source>
        <translation>%1Connect to robot</translation>
    </message>
    <message>
        <source>Robot connection status</source>
        <translation>Robot connection status</translation>
    </message>
    <message>
        <source>Update robot status</source>
        <translation>Update robot status</translation>
    </message>
    <message>
        <source>robot&apos;s status: %1</source>
        <translation>ロボットの状態: %1</translation>
    </message>
    <message>
        <source>Set objective</source>
        <translation>Set objective</translation>
    </message>
    <message>
        <source>robot&apos;s objective: %1</source>
        <translation>ロボットの目的: %1</translation>
    </message>
    <message>
        <source>Update robot warning</source>
        <translation>Update robot warning</translation>
    </message>
    <message>
        <source>robot: no warning</source>
        <translation>ロボット: 警告なし</translation>
    </message>
    <message>
        <source>robot warns: %1</source>
        <translation>ロボットの警告: %1</translation>
    </message>
    <message>
        <source>%1Robot connection status</source>
        <translation>%1Robot connection status</translation>
    </message>
    <message>
        <source>is no web server</source>
        <translation>Web サーバーではありません</translation>
    </message>
    <message>
        <source>is no Socket.IO relay (HTTP ?)</source>
        <translation>Socket.IO の中継サーバーではありません (HTTP ?)</translation>
    </message>
    <message>
        <source>is no Socket.IO relay (HTTP %1)</source>
        <translation>Socket.IO の中継サーバーではありません (HTTP %1)</translation>
    </message>
    <message>
        <source>answers another client&apos;s request</source>
        <translation>別のクライアントの要求に応答しています</translation>
    </message>
    <message>
        <source>sends a WebSocket extension that was not asked for</source>
        <translation>要求していない WebSocket 拡張を送ってきます</translation>
    </message>
    <message>
        <source>masks its messages, as only clients may</source>
        <translation>クライアントだけに許されるマスクをメッセージに付けています</translation>
    </message>
    <message>
        <source>sends a broken message</source>
        <translation>壊れたメッセージを送ってきます</translation>
    </message>
    <message>
        <source>sends too long a message</source>
        <translation>長すぎるメッセージを送ってきます</translation>
    </message>
    <message>
        <source>sends an unknown kind of message</source>
        <translation>不明な種類のメッセージを送ってきます</translation>
    </message>
    <message>
        <source>lacks the function %1</source>
        <translation>関数 %1 がありません</translation>
    </message>
    <message>
        <source>install a newer liblsl</source>
        <translation>新しい liblsl をインストールしてください</translation>
    </message>
    <message>
        <source>LSL is not installed</source>
        <translation>LSL がインストールされていません</translation>
    </message>
    <message>
        <source>get the liblsl package of labstreaminglayer.org, or name its file in FACENAV_LSL</source>
        <translation>labstreaminglayer.org の liblsl パッケージを入手するか、そのファイルを FACENAV_LSL で指定してください</translation>
    </message>
    <message>
        <source>the clock of the LSL stream&apos;s computer is not known: pulses are timed by their arrival</source>
        <translation>LSL ストリームのコンピューターの時計が分かりません: パルスの時刻は到着時刻です</translation>
    </message>
    <message>
        <source>the LSL stream&apos;s time stamps are more than a second off: pulses are timed by their arrival</source>
        <translation>LSL ストリームの時刻が 1 秒を超えてずれています: パルスの時刻は到着時刻です</translation>
    </message>
    <message>
        <source>no LSL stream of type Markers is there yet</source>
        <translation>種類 Markers の LSL ストリームがまだありません</translation>
    </message>
    <message>
        <source>no LSL stream named %1 is there yet</source>
        <translation>%1 という名前の LSL ストリームがまだありません</translation>
    </message>
    <message>
        <source>cannot be listened to (%1)</source>
        <translation>受信できません (%1)</translation>
    </message>
    <message>
        <source>a message was no pulse ({&quot;pulse&quot;: true} is expected): not counted</source>
        <translation>パルスでないメッセージがありました ({&quot;pulse&quot;: true} が必要です): 数えていません</translation>
    </message>
    <message>
        <source>unknown source of pulses &apos;%1&apos;</source>
        <translation>パルスの入力元 &apos;%1&apos; は不明です</translation>
    </message>
    <message>
        <source>udp:PORT, tcp:PORT, serial:DEVICE[:BAUD], serial:DEVICE:cts (or :dsr), lsl[:STREAM[:MARKER]], sound[:DEVICE or FILE.wav] (the coil&apos;s click); with :dead=SECONDS for another dead time</source>
        <translation>udp:PORT、tcp:PORT、serial:DEVICE[:BAUD]、serial:DEVICE:cts (または :dsr)、lsl[:STREAM[:MARKER]]、sound[:DEVICE または FILE.wav] (コイルのクリック音)。不感時間を変えるには :dead=SECONDS</translation>
    </message>
    <message>
        <source>%1 baud are not possible</source>
        <translation>%1 ボーは使えません</translation>
    </message>
    <message>
        <source>use 9600 or 115200</source>
        <translation>9600 か 115200 を使ってください</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>開けません (%1)</translation>
    </message>
    <message>
        <source>is the adapter plugged in, and may you use it (group dialout)?</source>
        <translation>アダプターは接続されていますか? 使用権限はありますか (dialout グループ)?</translation>
    </message>
    <message>
        <source>has no CTS and DSR lines to read</source>
        <translation>読み取れる CTS と DSR の線がありません</translation>
    </message>
    <message>
        <source>use another port, or bytes</source>
        <translation>別のポートか、バイトを使ってください</translation>
    </message>
    <message>
        <source>%1 was unplugged: no pulse arrives from it</source>
        <translation>%1 が外されました: そこからのパルスは届きません</translation>
    </message>
    <message>
        <source>the sound input is in use by another program</source>
        <translation>音声入力は別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>the sound input may not be used (group audio?)</source>
        <translation>音声入力の使用権限がありません (audio グループ?)</translation>
    </message>
    <message>
        <source>there is no such sound input</source>
        <translation>その音声入力はありません</translation>
    </message>
    <message>
        <source>the sound input cannot be opened (%1)</source>
        <translation>音声入力を開けません (%1)</translation>
    </message>
    <message>
        <source>close that program, or use its own input, as sound:default</source>
        <translation>そのプログラムを閉じるか、sound:default のようにその入力を使ってください</translation>
    </message>
    <message>
        <source>&apos;arecord -L&apos; lists the inputs; is the cable&apos;s card plugged in?</source>
        <translation>&apos;arecord -L&apos; で入力を一覧できます。ケーブルのカードは接続されていますか?</translation>
    </message>
    <message>
        <source>FaceNav was built without ALSA: no sound can be heard</source>
        <translation>FaceNav が ALSA なしでビルドされています: 音を取り込めません</translation>
    </message>
    <message>
        <source>install libasound2-dev and build again</source>
        <translation>libasound2-dev をインストールして、ビルドし直してください</translation>
    </message>
    <message>
        <source>the sound cannot be read (%1)</source>
        <translation>音声を読み取れません (%1)</translation>
    </message>
    <message>
        <source>a WAV or FLAC file is expected</source>
        <translation>WAV または FLAC ファイルが必要です</translation>
    </message>
    <message>
        <source>FaceNav was built without libsndfile: no sound file can be played</source>
        <translation>FaceNav が libsndfile なしでビルドされています: 音声ファイルを再生できません</translation>
    </message>
    <message>
        <source>install libsndfile1-dev and build again</source>
        <translation>libsndfile1-dev をインストールして、ビルドし直してください</translation>
    </message>
    <message>
        <source>a part of the sound was lost: clicks in it are not known</source>
        <translation>音声の一部が失われました: その間のクリック音は分かりません</translation>
    </message>
    <message>
        <source>the sound is over: no pulse arrives from it</source>
        <translation>音声が終わりました: そこからのパルスは届きません</translation>
    </message>
    <message>
        <source>%1 is gone: no click is heard</source>
        <translation>%1 がなくなりました: クリック音を検出できません</translation>
    </message>
    <message>
        <source>there is no such sound file</source>
        <translation>その音声ファイルはありません</translation>
    </message>
    <message>
        <source>not possible: too little of the face was measured (%1 measurement)</source>
        <translation>判定できません: 顔の計測範囲が足りません (計測 %1 回)</translation>
    </message>
    <message>
        <source>not possible: too little of the face was measured (%1 measurements)</source>
        <translation>判定できません: 顔の計測範囲が足りません (計測 %1 回)</translation>
    </message>
    <message>
        <source>passed: face %1 mm and %2 deg from where the MRI&apos;s is, %3 measurements</source>
        <translation>合格: 顔と MRI の顔のずれ %1 mm、%2 deg、計測 %3 回</translation>
    </message>
    <message>
        <source>failed: face %1 mm and %2 deg from where the MRI&apos;s is, %3 measurements</source>
        <translation>不合格: 顔と MRI の顔のずれ %1 mm、%2 deg、計測 %3 回</translation>
    </message>
    <message>
        <source>no skin beside the coil faces both cameras</source>
        <translation>コイルの横に、両方のカメラに面した皮膚がありません</translation>
    </message>
    <message>
        <source>too little texture beside the coil</source>
        <translation>コイルの横の模様が足りません</translation>
    </message>
    <message>
        <source>too few points of skin beside the coil</source>
        <translation>コイルの横の皮膚の点が少なすぎます</translation>
    </message>
    <message>
        <source>CAMERAS SWAPPED: exchange left and right</source>
        <translation>カメラが入れ替わっています: 左右を入れ替えてください</translation>
    </message>
    <message>
        <source>CAMERAS OUT OF STEP: trigger both together, or check cables and driver</source>
        <translation>カメラの時刻がずれています: 両方を同時にトリガーするか、ケーブルとドライバーを確認してください</translation>
    </message>
    <message>
        <source>OTHER CAMERAS&apos; CALIBRATION: give the right stereo.yml, or calibrate</source>
        <translation>別のカメラの較正です: 正しい stereo.yml を指定するか、較正してください</translation>
    </message>
    <message>
        <source>CAMERAS MOVED: calibrate them again</source>
        <translation>カメラが動きました: 較正し直してください</translation>
    </message>
    <message>
        <source>CAMERA AWAY: plug it in again, the session goes on by itself</source>
        <translation>カメラが外れています: 接続し直すと、セッションは自動で続きます</translation>
    </message>
    <message>
        <source>DRIFT: the face no longer matches the MRI, align again</source>
        <translation>ドリフト: 顔が MRI と合わなくなりました。位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>REGISTRATION NOT CHECKED: show the whole face to both cameras</source>
        <translation>位置合わせ未確認: 顔全体を両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>REGISTRATION FAILED: the face is %1 mm and %2 deg off, align again</source>
        <translation>位置合わせ不合格: 顔が %1 mm、%2 deg ずれています。位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>ALIGNMENT JUDGED WRONG: align again</source>
        <translation>位置合わせは誤りと判定: 位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>FACE NOT FOUND: turn the face towards the cameras</source>
        <translation>顔が見つかりません: 顔をカメラに向けてください</translation>
    </message>
    <message>
        <source>FACE COVERED OR TURNED AWAY: move coil and hand aside, face the cameras</source>
        <translation>顔が覆われているか横を向いています: コイルと手をどけ、カメラを向いてください</translation>
    </message>
    <message>
        <source>FACE TOO FAR AWAY: come nearer to the cameras</source>
        <translation>顔が遠すぎます: カメラに近づいてください</translation>
    </message>
    <message>
        <source>PICTURE BLURRED: hold still, check focus</source>
        <translation>画像がぶれています: 動かず、ピントを確認してください</translation>
    </message>
    <message>
        <source>ONE CAMERA DOES NOT SEE THE FACE: clear its view</source>
        <translation>一方のカメラから顔が見えません: 視界を空けてください</translation>
    </message>
    <message>
        <source>CAMERA FROZEN: its picture repeats</source>
        <translation>カメラ停止: 同じ画像が繰り返されています</translation>
    </message>
    <message>
        <source>NO PICTURE: check both cameras and the light</source>
        <translation>画像がありません: 両方のカメラと照明を確認してください</translation>
    </message>
    <message>
        <source>CAMERAS DISAGREE: one has moved, or they expose at different moments</source>
        <translation>カメラが一致しません: 一方が動いたか、露光の時刻が異なります</translation>
    </message>
    <message>
        <source>ANOTHER PERSON: only the patient&apos;s face is followed</source>
        <translation>別の人物です: 追跡するのは患者の顔だけです</translation>
    </message>
    <message>
        <source>HEAD NOT SEEN: show its marker to the tracker</source>
        <translation>頭が見えません: マーカーを追跡装置に見せてください</translation>
    </message>
    <message>
        <source>COIL NOT SEEN: show its marker to the tracker</source>
        <translation>コイルが見えません: マーカーを追跡装置に見せてください</translation>
    </message>
    <message>
        <source>FACE NOT SEEN: turn the face towards the cameras</source>
        <translation>顔が見えません: 顔をカメラに向けてください</translation>
    </message>
    <message>
        <source>FACE HIDDEN: move the coil or hand aside</source>
        <translation>顔が隠れています: コイルか手をどけてください</translation>
    </message>
    <message>
        <source>FACE DOUBTFUL: hold still, look towards the cameras</source>
        <translation>顔の追跡が不確かです: 動かず、カメラの方を見てください</translation>
    </message>
    <message>
        <source>CAMERA FAULT: check both cameras</source>
        <translation>カメラ異常: 両方のカメラを確認してください</translation>
    </message>
    <message>
        <source>NO NEW IMAGES: check the cameras</source>
        <translation>新しい画像がありません: カメラを確認してください</translation>
    </message>
    <message>
        <source>COIL NOT SEEN: turn the marker towards the cameras</source>
        <translation>コイルが見えません: マーカーをカメラに向けてください</translation>
    </message>
    <message>
        <source>COIL DOUBTFUL: show the whole marker to both cameras</source>
        <translation>コイルの追跡が不確かです: マーカー全体を両方のカメラに見せてください</translation>
    </message>
    <message>
        <source>alignment too uncertain (95 % within %1 mm, %2 allowed): align again</source>
        <translation>位置合わせが不確かすぎます (95 % が %1 mm 以内、許容 %2): 位置合わせをやり直してください</translation>
    </message>
    <message>
        <source>NOT ALIGNED: align the head first</source>
        <translation>位置合わせ未実施: 先に頭の位置合わせを行ってください</translation>
    </message>
    <message>
        <source>%1 mm beside the target (%2 allowed)</source>
        <translation>標的から横に %1 mm (許容 %2)</translation>
    </message>
    <message>
        <source>%1 mm too deep (%2 allowed)</source>
        <translation>%1 mm 深すぎる (許容 %2)</translation>
    </message>
    <message>
        <source>%1 mm too high (%2 allowed)</source>
        <translation>%1 mm 高すぎる (許容 %2)</translation>
    </message>
    <message>
        <source>tilted by %1 deg (%2 allowed)</source>
        <translation>傾き %1 deg (許容 %2)</translation>
    </message>
    <message>
        <source>turned by %1 deg (%2 allowed)</source>
        <translation>ねじれ %1 deg (許容 %2)</translation>
    </message>
    <message>
        <source>no picture before the pulse</source>
        <translation>パルスの前に画像がありません</translation>
    </message>
    <message>
        <source>no picture within %1 s after the pulse</source>
        <translation>パルスの後 %1 s 以内に画像がありません</translation>
    </message>
    <message>
        <source>another coil was chosen at that moment</source>
        <translation>その時点で別のコイルが選ばれました</translation>
    </message>
    <message>
        <source>no picture for %1 s</source>
        <translation>%1 s 間、画像がありません</translation>
    </message>
    <message>
        <source>it is not known which of the two coils gave it</source>
        <translation>2 つのコイルのどちらで刺激したか分かりません</translation>
    </message>
    <message>
        <source>the coil &apos;%1&apos; was not followed</source>
        <translation>コイル &apos;%1&apos; は追跡されていませんでした</translation>
    </message>
    <message>
        <source>gap of %1 mm to the skin (%2 planned, %3 more allowed)</source>
        <translation>皮膚との隙間 %1 mm (計画 %2、許容は +%3)</translation>
    </message>
    <message>
        <source>no target was chosen</source>
        <translation>標的が選ばれていませんでした</translation>
    </message>
    <message>
        <source>given in a pause</source>
        <translation>一時停止中の刺激</translation>
    </message>
    <message>
        <source>given in a pause; %1</source>
        <translation>一時停止中の刺激; %1</translation>
    </message>
    <message>
        <source>coil followed</source>
        <translation>追跡するコイル</translation>
    </message>
    <message>
        <source>%1, from frame %2 on</source>
        <translation>%1、フレーム %2 から</translation>
    </message>
    <message>
        <source>camera moved</source>
        <translation>カメラのずれ</translation>
    </message>
    <message>
        <source>registration check</source>
        <translation>位置合わせの確認</translation>
    </message>
    <message>
        <source>second coil followed</source>
        <translation>追跡する第 2 コイル</translation>
    </message>
    <message>
        <source>pulse pictures</source>
        <translation>パルスの画像</translation>
    </message>
    <message>
        <source>kept again, %1 frames are missing</source>
        <translation>記録を再開、%1 フレーム欠落</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>記録なし: %1</translation>
    </message>
    <message>
        <source>clock set</source>
        <translation>時計の変更</translation>
    </message>
    <message>
        <source>the computer&apos;s clock was set back by %1 s; the order of pulses and the time between them are right</source>
        <translation>コンピューターの時計が %1 s 戻されました。パルスの順序と間隔は正しく保たれています</translation>
    </message>
    <message>
        <source>the computer&apos;s clock was set forward by %1 s; the order of pulses and the time between them are right</source>
        <translation>コンピューターの時計が %1 s 進められました。パルスの順序と間隔は正しく保たれています</translation>
    </message>
    <message>
        <source>the session&apos;s folder had been removed and is made again</source>
        <translation>セッションのフォルダーが削除されていたため、作り直しました</translation>
    </message>
    <message>
        <source>log resumed</source>
        <translation>記録の再開</translation>
    </message>
    <message>
        <source>nothing was logged for %1 s%2</source>
        <translation>%1 s 間、記録がありません%2</translation>
    </message>
    <message>
        <source>%1 s after the start</source>
        <translation>開始から %1 s 後</translation>
    </message>
    <message>
        <source>recording ended</source>
        <translation>記録の終わり</translation>
    </message>
    <message>
        <source>stopped by a fault</source>
        <translation>異常により停止</translation>
    </message>
    <message>
        <source>the recording had ended</source>
        <translation>記録が終わっていました</translation>
    </message>
    <message>
        <source>after %1 pulses and %2 s</source>
        <translation>%1 パルス、%2 s の後</translation>
    </message>
    <message>
        <source>%1, within %2 s, not counted</source>
        <translation>%1、%2 s 以内のため数えません</translation>
    </message>
    <message>
        <source>pause length</source>
        <translation>一時停止の長さ</translation>
    </message>
    <message>
        <source>the sound output is in use by another program</source>
        <translation>音声出力は別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>this machine has no sound output</source>
        <translation>このコンピューターに音声出力がありません</translation>
    </message>
    <message>
        <source>the sound output cannot play 16-bit samples</source>
        <translation>音声出力が 16 ビットの音を再生できません</translation>
    </message>
    <message>
        <source>FaceNav was built without ALSA</source>
        <translation>FaceNav が ALSA なしでビルドされています</translation>
    </message>
    <message>
        <source>the sound output has gone</source>
        <translation>音声出力がなくなりました</translation>
    </message>
    <message>
        <source>no sound: %1</source>
        <translation>音なし: %1</translation>
    </message>
    <message>
        <source>the recording has no pictures to know the face by</source>
        <translation>記録に本人を見分けるための画像がありません</translation>
    </message>
    <message>
        <source>three steps, big buttons</source>
        <translation>3 つの手順、大きなボタン</translation>
    </message>
    <message>
        <source>The recording is over: press FINISH</source>
        <translation>記録が終わりました: 「終了」を押してください</translation>
    </message>
    <message>
        <source>MEPs by field</source>
        <translation>電場による MEP</translation>
    </message>
    <message>
        <source>type microvolts, as 350; empty: not known</source>
        <translation>マイクロボルトで入力してください (例: 350)。空欄: 不明</translation>
    </message>
    <message>
        <source>no MEP is at the time of a pulse</source>
        <translation>パルスの時刻に合う MEP がありません</translation>
    </message>
    <message>
        <source>is it this session&apos;s file?</source>
        <translation>このセッションのファイルですか?</translation>
    </message>
    <message>
        <source>opening the MRI</source>
        <translation>MRI を開いています</translation>
    </message>
    <message>
        <source>opening masks</source>
        <translation>マスクを開いています</translation>
    </message>
    <message>
        <source>opening surfaces</source>
        <translation>表面を開いています</translation>
    </message>
    <message>
        <source>the window was closed</source>
        <translation>ウィンドウが閉じられました</translation>
    </message>
    <message>
        <source>repair them: Check and repair the cameras</source>
        <translation>修復してください: 「カメラの点検と修復」</translation>
    </message>
    <message>
        <source>the intensity of pulse %1 is not known</source>
        <translation>パルス %1 の強度が不明です</translation>
    </message>
    <message>
        <source>type the output that is set, before the next pulse</source>
        <translation>次のパルスの前に、設定した出力を入力してください</translation>
    </message>
    <message>
        <source>lsl, invesalius:5000, osc:9000</source>
        <translation>lsl, invesalius:5000, osc:9000</translation>
    </message>
    <message>
        <source>guidance stopped</source>
        <translation>誘導を停止しました</translation>
    </message>
    <message>
        <source>the session is being ended</source>
        <translation>セッションを終了しています</translation>
    </message>
    <message>
        <source>another case was opened</source>
        <translation>別の症例が開かれました</translation>
    </message>
    <message>
        <source>another recording was opened</source>
        <translation>別の記録が開かれました</translation>
    </message>
    <message>
        <source>the cameras were opened again</source>
        <translation>カメラが開き直されました</translation>
    </message>
    <message>
        <source>another session was started</source>
        <translation>別のセッションが開始されました</translation>
    </message>
    <message>
        <source>its coil stands on edge: its %1 axis, not z, points into the head or out of it; are its axes in another order?</source>
        <translation>コイルが頭部に対して立っています: z 軸ではなく %1 軸が頭部の内側または外側を向いています。座標軸の順序が異なりませんか?</translation>
    </message>
    <message>
        <source>its poses lie %1 mm from the skin, and %2 mm if its lengths are %3: export it in millimetres</source>
        <translation>姿勢が皮膚から %1 mm 離れています。長さの単位が %3 なら %2 mm です: ミリメートルで書き出してください</translation>
    </message>
    <message>
        <source>its cells are separated as a spreadsheet does it; decimal commas are points</source>
        <translation>欄の区切りが表計算ソフトの形式です。小数点のコンマはピリオドとして読みます</translation>
    </message>
    <message>
        <source>its quaternion has the length %1 instead of 1</source>
        <translation>四元数の長さが 1 ではなく %1 です</translation>
    </message>
    <message>
        <source>the GIFTI file&apos;s data are damaged</source>
        <translation>GIFTI ファイルのデータが壊れています</translation>
    </message>
    <message>
        <source>the GIFTI file&apos;s data end too early</source>
        <translation>GIFTI ファイルのデータが途中で終わっています</translation>
    </message>
    <message>
        <source>the file with the GIFTI file&apos;s data cannot be read</source>
        <translation>GIFTI ファイルのデータを収めたファイルを読み込めません</translation>
    </message>
    <message>
        <source>the GIFTI file holds a value that is no number</source>
        <translation>GIFTI ファイルに数値でない値があります</translation>
    </message>
    <message>
        <source>the GIFTI file&apos;s data are of an unknown encoding</source>
        <translation>GIFTI ファイルのデータの符号化方式が不明です</translation>
    </message>
    <message>
        <source>the GIFTI file holds an array that is no table</source>
        <translation>GIFTI ファイルに表ではない配列があります</translation>
    </message>
    <message>
        <source>%1 items, the first</source>
        <translation>%1 項目、最初は</translation>
    </message>
    <message>
        <source>four shells 2</source>
        <translation>four shells 2</translation>
    </message>
    <message>
        <source>three shells 2</source>
        <translation>three shells 2</translation>
    </message>
    <message>
        <source>the session is paused</source>
        <translation>セッションを一時停止しました</translation>
    </message>
    <message>
        <source>the session was not paused</source>
        <translation>セッションは一時停止していません</translation>
    </message>
    <message>
        <source>the session goes on</source>
        <translation>セッションを再開しました</translation>
    </message>
    <message>
        <source>a pulse was given</source>
        <translation>刺激しました</translation>
    </message>
    <message>
        <source>%1: not taken: there is no case that it could belong to</source>
        <translation>%1: 受け取れません: 追加先の症例がありません</translation>
    </message>
    <message>
        <source>command %1 from %2: %3</source>
        <translation>%2 からの命令 %1: %3</translation>
    </message>
    <message>
        <source>the target &apos;%1&apos; cannot be taken now: %2</source>
        <translation>標的 &apos;%1&apos; を今は採用できません: %2</translation>
    </message>
    <message>
        <source>the case has it already</source>
        <translation>症例に既にあります</translation>
    </message>
    <message>
        <source>poses were stopped already</source>
        <translation>姿勢の送信は既に停止しています</translation>
    </message>
    <message>
        <source>poses were sent</source>
        <translation>姿勢は送信中です</translation>
    </message>
    <message>
        <source>no poses until start</source>
        <translation>開始の命令があるまで姿勢を送信しません</translation>
    </message>
    <message>
        <source>poses are sent again</source>
        <translation>姿勢の送信を再開しました</translation>
    </message>
    <message>
        <source>cannot be written (it was removed)</source>
        <translation>書き込めません (削除されています)</translation>
    </message>
    <message>
        <source>leave the case&apos;s folder in its place</source>
        <translation>症例のフォルダーを移動しないでください</translation>
    </message>
    <message>
        <source>%1; not sent: %2</source>
        <translation>%1; 送信できませんでした: %2</translation>
    </message>
    <message>
        <source>target taken</source>
        <translation>標的の採用</translation>
    </message>
    <message>
        <source>no session runs</source>
        <translation>実行中のセッションがありません</translation>
    </message>
    <message>
        <source>the head&apos;s pose has no name</source>
        <translation>頭の姿勢の名前がありません</translation>
    </message>
    <message>
        <source>type it, as SubjectToTracker</source>
        <translation>SubjectToTracker のように入力してください</translation>
    </message>
    <message>
        <source>another tracker is used</source>
        <translation>別の追跡装置に切り替わりました</translation>
    </message>
    <message>
        <source>there is no report in the language &apos;%1&apos;</source>
        <translation>言語「%1」のレポートはありません</translation>
    </message>
    <message>
        <source>%1each voxel of vectors has 3 values</source>
        <translation>%1ベクトルには各ボクセルに 3 個の値が必要です</translation>
    </message>
    <message>
        <source>nasion</source>
        <translation>鼻根点</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>先端</translation>
    </message>
    <message>
        <source>HEAD LOST</source>
        <translation>頭部の追跡喪失</translation>
    </message>
    <message>
        <source>COIL LOST</source>
        <translation>コイルの追跡喪失</translation>
    </message>
    <message>
        <source>coil positions of SimNIBS</source>
        <translation>SimNIBS のコイル位置</translation>
    </message>
    <message>
        <source>board</source>
        <translation>ボード</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>left prefrontal cortex (DLPFC)</source>
        <translation>左前頭前野 (DLPFC)</translation>
    </message>
    <message>
        <source>right prefrontal cortex (DLPFC)</source>
        <translation>右前頭前野 (DLPFC)</translation>
    </message>
    <message>
        <source>look at the left %1</source>
        <translation>左%1を確認してください</translation>
    </message>
    <message>
        <source>look at the right %1</source>
        <translation>右%1を確認してください</translation>
    </message>
    <message>
        <source>%1: the mask&apos;s edge is uncertain by %2 mm there (confidence %3)</source>
        <translation>%1: そこでのマスクの縁の不確かさは %2 mm です (確信度 %3)</translation>
    </message>
    <message>
        <source>%1 views, %2 px</source>
        <translation>%1 視点、残差 %2 px</translation>
    </message>
    <message>
        <source>aligned: by a file that states its error</source>
        <translation>位置合わせ済み: 誤差を記したファイルによる</translation>
    </message>
    <message>
        <source>aligned: %1 mm rms over %2 points</source>
        <translation>位置合わせ済み: %2 点で %1 mm rms</translation>
    </message>
    <message>
        <source>not aligned: the face fits this MRI, but was measured too coarsely to tell this person from others%1</source>
        <translation>位置合わせできません: 顔はこの MRI に合いますが、計測が粗すぎて、この人と他の人を区別できません%1</translation>
    </message>
    <message>
        <source>bring the cameras nearer, project dots, and keep hair and hands off the face; or check name and date of birth, and confirm that this is the patient&apos;s own MRI</source>
        <translation>カメラを近づけ、ドットを投影し、髪や手が顔にかからないようにしてください。または氏名と生年月日を確かめ、患者本人の MRI であることを確認してください</translation>
    </message>
    <message>
        <source>the face was measured too coarsely to tell this person from others: a person confirmed that this is the patient&apos;s own MRI</source>
        <translation>顔の計測が粗すぎて、この人と他の人を区別できませんでした: 患者本人の MRI であることを人が確認しました</translation>
    </message>
    <message>
        <source>not aligned: the face does not fit this MRI, or was measured too coarsely to tell%1</source>
        <translation>位置合わせできません: 顔がこの MRI と合わないか、計測が粗くて判定できません%1</translation>
    </message>
    <message>
        <source>check that this is the patient&apos;s own MRI; if it is, bring the cameras nearer, project dots, and keep hair and hands off the face</source>
        <translation>患者本人の MRI か確認してください。本人のものなら、カメラを近づけ、ドットを投影し、髪と手を顔からどけてください</translation>
    </message>
    <message>
        <source>trigger both cameras together; if they are, calibrate again</source>
        <translation>両方のカメラを同時にトリガーしてください。すでにそうしている場合は、較正し直してください</translation>
    </message>
    <message>
        <source>not aligned: the face fits this MRI, but only to %1 mm, where other persons&apos; faces may fit as well</source>
        <translation>顔はこの MRI に合いますが、%1 mm の粗さでしか定まらず、他の人の顔も合うことがあります</translation>
    </message>
    <message>
        <source>the pictures do not fit the calibration (%1 px across the epipolar lines): a camera has moved since, or they were taken at two moments</source>
        <translation>画像が較正と合いません (エピポーラ線に直交して %1 px): 較正後にカメラが動いたか、二つの画像が別の時点のものです</translation>
    </message>
    <message>
        <source>linked in facenav-lab</source>
        <translation>facenav-lab でリンク</translation>
    </message>
    <message>
        <source>the two cameras place the face differently: one has moved on its mount since the alignment, or they expose at different moments</source>
        <translation>二台のカメラで顔の位置が一致しません: 位置合わせ後に一方が台座の上で動いたか、露光の時刻が異なります</translation>
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
    <message>
        <source>%1 LOST</source>
        <translation>%1 追跡喪失</translation>
    </message>
    <message>
        <source>%1 weak</source>
        <translation>%1 不安定</translation>
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
        <translation>アーカイブへの接続</translation>
    </message>
    <message>
        <source>✓ the archive answers and knows us</source>
        <translation>✓ アーカイブが応答し、この装置を認識しました</translation>
    </message>
    <message>
        <source>Asking the archive</source>
        <translation>アーカイブへの問い合わせ</translation>
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
        <translation>取得</translation>
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
        <translation>AE タイトル</translation>
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
    <message>
        <source>bull&apos;s eye</source>
        <translation>ブルズアイ表示</translation>
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
    <message>
        <source>left camera</source>
        <translation>左カメラ</translation>
    </message>
    <message>
        <source>right camera</source>
        <translation>右カメラ</translation>
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
        <translation>カメラの起動</translation>
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
        <translation>撮影</translation>
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
    <message>
        <source>d MMM</source>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>yyyy年M月d日</translation>
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
        <translation>カメラの検索</translation>
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
    <message>
        <source>slice along the handle</source>
        <translation>ハンドル方向の断面</translation>
    </message>
    <message>
        <source>slice across the handle</source>
        <translation>ハンドル横断方向の断面</translation>
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
    <message>
        <source>session to compare with</source>
        <translation>比較相手のセッション</translation>
    </message>
    <message>
        <source>differences of the sessions</source>
        <translation>セッション間の差</translation>
    </message>
</context>
<context>
    <name>facenav::ui::CortexPresenter</name>
    <message>
        <source>Making the cortex</source>
        <translation>皮質の作成</translation>
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
    <message>
        <source>coil of the library</source>
        <translation>ライブラリのコイル</translation>
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
    <message>
        <source>size of the tool</source>
        <translation>ツールの大きさ</translation>
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
        <translation>修正した脳の保存</translation>
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
    <message>
        <source>adverse events</source>
        <translation>有害事象</translation>
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
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>キャンセルしました</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Writing DICOM</source>
        <translation>DICOM の書き出し</translation>
    </message>
    <message>
        <source>Sent: %1 files</source>
        <translation>送信しました: %1 ファイル</translation>
    </message>
    <message>
        <source>Written: %1 images with the patient&apos;s name in %2</source>
        <translation>書き出しました: %2 に、患者の氏名を含む画像 %1 枚</translation>
    </message>
    <message>
        <source>Written: segments of %1 targets with the patient&apos;s name in %2</source>
        <translation>書き出しました: %2 に、患者の氏名を含む、標的 %1 個のセグメント</translation>
    </message>
    <message>
        <source>Written: the report with the patient&apos;s name in %1</source>
        <translation>書き出しました: %1 に、患者の氏名を含むレポート</translation>
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
    <message>
        <source>DICOM: the MRI with targets and coils drawn into it, a series for the archive</source>
        <translation>DICOM: 標的とコイルを描き込んだ MRI (アーカイブ用の 1 シリーズ)</translation>
    </message>
    <message>
        <source>DICOM: targets and coils as segments beside the scan, one object</source>
        <translation>DICOM: スキャンに添える標的とコイルのセグメント (1 オブジェクト)</translation>
    </message>
    <message>
        <source>DICOM: the report of a session as a document, one object</source>
        <translation>DICOM: セッションのレポート文書 (1 オブジェクト)</translation>
    </message>
    <message>
        <source>the folder of the DICOM files that the case was prepared from; patient and study are taken from there</source>
        <translation>症例の作成に使った DICOM ファイルのフォルダー。患者と検査の情報はここから取ります</translation>
    </message>
    <message>
        <source>folder of the original DICOM files</source>
        <translation>元の DICOM ファイルのフォルダー</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>選択(&amp;H)…</translation>
    </message>
    <message>
        <source>where the original DICOM files are</source>
        <translation>元の DICOM ファイルの場所</translation>
    </message>
    <message>
        <source>&amp;Source</source>
        <translation>元データ(&amp;S)</translation>
    </message>
    <message>
        <source>Send it to the &amp;archive, %1</source>
        <translation>アーカイブ %1 に送信(&amp;A)</translation>
    </message>
    <message>
        <source>after it is written; the archive is set up in Prepare, page Archive</source>
        <translation>書き出した後に送信します。アーカイブは準備の画面の「アーカイブ」のページで設定します</translation>
    </message>
    <message>
        <source>What is written names the patient, as the original files do.</source>
        <translation>書き出すファイルには、元のファイルと同じく患者の氏名が含まれます。</translation>
    </message>
    <message>
        <source>Folder of the original DICOM files</source>
        <translation>元の DICOM ファイルのフォルダー</translation>
    </message>
    <message>
        <source>the case has no session yet</source>
        <translation>症例にセッションがまだありません</translation>
    </message>
    <message>
        <source>name the folder of the original DICOM files first</source>
        <translation>先に元の DICOM ファイルのフォルダーを指定してください</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>書き出しています</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldImportPresenter</name>
    <message>
        <source>a field belongs to the pose of one target: plan that target first</source>
        <translation>電場は 1 つの標的の姿勢に対するものです: 先にその標的を計画してください</translation>
    </message>
    <message>
        <source>the file holds values alone: choose the GIFTI surface that they belong to</source>
        <translation>ファイルには値だけがあります: その値が属する GIFTI の表面を選んでください</translation>
    </message>
    <message>
        <source>Reading the field</source>
        <translation>電場の読み込み</translation>
    </message>
    <message>
        <source>reading …</source>
        <translation>読み込んでいます …</translation>
    </message>
    <message>
        <source>maximum %1 V/m, 99.9th percentile %2 V/m at %3 A/µs, at %4 %5 %6 mm (RAS)</source>
        <translation>%3 A/µs で最大値 %1 V/m、99.9 パーセンタイル %2 V/m、最大点 %4 %5 %6 mm (RAS)</translation>
    </message>
    <message>
        <source>Taking in the field</source>
        <translation>電場の取り込み</translation>
    </message>
    <message>
        <source>the field is kept with &apos;%1&apos;: menu Field, tier 3</source>
        <translation>電場を &apos;%1&apos; とともに保存しました: 「電場」メニュー、段階 3</translation>
    </message>
</context>
<context>
    <name>facenav::ui::FieldImportWindow</name>
    <message>
        <source>FaceNav: electric field from another program</source>
        <translation>FaceNav: ほかのプログラムの電場</translation>
    </message>
    <message>
        <source>close; the field does not come in</source>
        <translation>閉じます。電場を取り込みません</translation>
    </message>
    <message>
        <source>the target for whose pose the field was computed</source>
        <translation>電場がその姿勢について計算された標的</translation>
    </message>
    <message>
        <source> A/µs</source>
        <translation> A/µs</translation>
    </message>
    <message>
        <source>the rate of the current that the field is for; SimNIBS takes 1 A/µs</source>
        <translation>この電場の電流変化率。SimNIBS では 1 A/µs です</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>標的(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>電流変化率(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>表面(&amp;S)</translation>
    </message>
    <message>
        <source>the GIFTI surface that the values belong to</source>
        <translation>値が属する GIFTI の表面</translation>
    </message>
    <message>
        <source>Surface (*.gii)</source>
        <translation>表面 (*.gii)</translation>
    </message>
    <message>
        <source>T&amp;1</source>
        <translation>T&amp;1</translation>
    </message>
    <message>
        <source>the NIfTI that the other program used; may stay empty</source>
        <translation>ほかのプログラムが使った NIfTI。空欄でも構いません</translation>
    </message>
    <message>
        <source>NIfTI (*.nii *.nii.gz)</source>
        <translation>NIfTI (*.nii *.nii.gz)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>It is a &amp;scan</source>
        <translation>これはスキャン(&amp;S)</translation>
    </message>
    <message>
        <source>no field: prepares a case of it</source>
        <translation>電場ではありません: このファイルから症例を準備します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>the field does not come in (Esc)</source>
        <translation>電場を取り込みません (Esc)</translation>
    </message>
    <message>
        <source>&amp;Bring in</source>
        <translation>取り込む(&amp;B)</translation>
    </message>
    <message>
        <source>keeps the field with the target; an earlier one is replaced (Ctrl+Return)</source>
        <translation>電場を標的とともに保存します。以前の電場は置き換えられます (Ctrl+Return)</translation>
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
    <message>
        <source>unit of the current</source>
        <translation>電流の単位</translation>
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
        <translation>開始</translation>
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
        <translation>症例の読み込み</translation>
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
        <translation>顔の計測</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>The coil&apos;s calibration is old or not recorded: tell the clinic.</source>
        <translation>コイルの較正が古いか、記録がありません: 病院に連絡してください。</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>終了処理</translation>
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
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
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
    <message>
        <source>%1 items</source>
        <translation>%1 項目</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>取り込み不可</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
</context>
<context>
    <name>facenav::ui::ImportPresenter</name>
    <message>
        <source>Reading the files</source>
        <translation>ファイルの読み込み</translation>
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
    <message>
        <source>%1 came in (Ctrl+Z in Plan takes them back)</source>
        <translation>%1を取り込みました (計画の画面で Ctrl+Z を押すと取り消せます)</translation>
    </message>
    <message>
        <source>session of %1</source>
        <translation>%1 のセッション</translation>
    </message>
    <message>
        <source> with %1</source>
        <translation> (%1)</translation>
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
        <translation>DICOM フォルダーを読む(&amp;R)…</translation>
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
        <translation>実施した刺激、再生、レポート (Ctrl+4)</translation>
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
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>FaceNav speaks %1 from its next start</source>
        <translation>次回の起動から %1 で表示します</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>システムに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>テーマ(&amp;H)</translation>
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
    <message>
        <source>slices through the brain</source>
        <translation>脳の断面</translation>
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
    <message>
        <source>method of the threshold</source>
        <translation>閾値の測定方法</translation>
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
        <translation>回答するパルスがまだありません: 先に 1 回刺激してください</translation>
    </message>
    <message>
        <source>Pulse %1 is answered: give the next one</source>
        <translation>パルス %1 は回答済みです: 次の 1 回を刺激してください</translation>
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
        <translation>出力を %1 % に設定し、1 回刺激してから回答してください
%2</translation>
    </message>
    <message>
        <source>site %1 of %2: %3</source>
        <translation>点 %1/%2: %3</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OfferPanel</name>
    <message>
        <source>offered target</source>
        <translation>候補の標的</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Show in Plan</source>
        <translation>計画で表示</translation>
    </message>
    <message>
        <source>draws the offered coil in the head, in place of the active target&apos;s</source>
        <translation>選択中の標的のコイルに代えて、候補のコイルを頭部に描きます</translation>
    </message>
    <message>
        <source>goes to Plan, where the offered coil is drawn in the head</source>
        <translation>計画の画面に移ります。候補のコイルを頭部に描きます</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>puts it into the plan, one step to undo; the chosen target stays as it is</source>
        <translation>計画に加えます。1 回の操作として元に戻せます。選択中の標的は変わりません</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>puts it away; it returns only if the other program moves it</source>
        <translation>候補から外します。ほかのプログラムが動かした場合だけ、再び現れます</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OffersPresenter</name>
    <message>
        <source>from %1, at %2 (RAS, mm)</source>
        <translation>%1 から、位置 %2 (RAS、mm)</translation>
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
    <message>
        <source>outputs to other programs</source>
        <translation>ほかのプログラムへの出力</translation>
    </message>
</context>
<context>
    <name>facenav::ui::OverlayPresenter</name>
    <message>
        <source>Reading the overlays</source>
        <translation>オーバーレイの読み込み</translation>
    </message>
    <message>
        <source>Adding an overlay</source>
        <translation>オーバーレイの追加</translation>
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
        <translation>指定どおり</translation>
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
        <translation>追加 …</translation>
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
    <message>
        <source>overlays</source>
        <translation>オーバーレイ</translation>
    </message>
    <message>
        <source>space of the next file</source>
        <translation>次のファイルの空間</translation>
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
    <message>
        <source>coordinates x y z, mm</source>
        <translation>座標 x y z (mm)</translation>
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
        <translation>汎用 8 の字 (指定なし)</translation>
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
    <message>
        <source>search the targets</source>
        <translation>標的の検索</translation>
    </message>
    <message>
        <source>note of the target</source>
        <translation>標的のメモ</translation>
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
        <translation>シリーズの検索</translation>
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
        <translation>症例の読み込み</translation>
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
        <translation>準備</translation>
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
        <translation>刺激を記録</translation>
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
        <translation>刺激後に入力した値。ダブルクリックで入力し直せます</translation>
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
    <message>
        <source>number that is coloured</source>
        <translation>色で示す数値</translation>
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
        <translation>画像の読み込み</translation>
    </message>
    <message>
        <source>no picture was kept of this frame</source>
        <translation>このフレームの画像は保存されていません</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>記録の読み込み</translation>
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
        <source>lost</source>
        <translation>追跡喪失</translation>
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
        <translation>レポートの作成</translation>
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
        <translation>このまま続ける</translation>
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
        <translation>セッション一覧の読み込み</translation>
    </message>
    <message>
        <source>Reading the session</source>
        <translation>セッションの読み込み</translation>
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
    <message>
        <source>3-D view</source>
        <translation>3-D 表示</translation>
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
        <translation>刺激するコイル</translation>
    </message>
    <message>
        <source>which of both coils gives the pulses of the next session</source>
        <translation>次のセッションで刺激するコイル</translation>
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
        <translation>どちらで刺激?</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SeriesPage</name>
    <message>
        <source>Read DICOM folder…</source>
        <translation>DICOM フォルダーを読む…</translation>
    </message>
    <message>
        <source>Read NIfTI file…</source>
        <translation>NIfTI ファイルを読む…</translation>
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
        <translation>DICOM フォルダーを読む</translation>
    </message>
    <message>
        <source>Read NIfTI</source>
        <translation>NIfTI を読む</translation>
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
        <translation>位置の喪失</translation>
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
        <translation>P キーのほかにパルスを受け取る先: %1。受信するだけで、刺激はしません。</translation>
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
    <message>
        <source>reason of the pause</source>
        <translation>一時停止の理由</translation>
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
        <translation>刺激時のコイルと標的の距離、中央値 / 95 パーセンタイル (mm)</translation>
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
    <message>
        <source>your name or initials</source>
        <translation>氏名またはイニシャル</translation>
    </message>
</context>
<context>
    <name>facenav::ui::SetupPresenter</name>
    <message>
        <source>Looking for cameras</source>
        <translation>カメラの検索</translation>
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
        <translation>カメラの起動</translation>
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
    <message>
        <source>kept pair</source>
        <translation>保存済みのペア</translation>
    </message>
    <message>
        <source>name of this pair</source>
        <translation>このペアの名前</translation>
    </message>
    <message>
        <source>coil of the library</source>
        <translation>ライブラリのコイル</translation>
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
    <message>
        <source>note of the sign-off</source>
        <translation>承認のメモ</translation>
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
        <translation>承認</translation>
    </message>
    <message>
        <source>Rejecting the scan</source>
        <translation>スキャンの却下</translation>
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
    <message>
        <source>slice, %1</source>
        <translation>断面、%1</translation>
    </message>
    <message>
        <source>left: crosshair   wheel, page up and down: slice   right: zoom   middle: pan   Ctrl+left: window/level   double click: choose   R: zoom, pan and window as at first   right click: menu</source>
        <translation>左: 十字線   ホイール、Page Up/Page Down: 断面   右: 拡大縮小   中央: 移動   Ctrl+左: ウィンドウ/レベル   ダブルクリック: 選択   R: 倍率、位置、階調を最初の状態に   右クリック: メニュー</translation>
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
    <name>facenav::ui::TrackerPanel</name>
    <message>
        <source>poses of head and coil from OpenIGTLink</source>
        <translation>頭とコイルの姿勢を OpenIGTLink から受け取ります</translation>
    </message>
    <message>
        <source>Or another tracker, without cameras</source>
        <translation>または別の追跡装置 (カメラなし)</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>OpenIGTLink server of the tracker, and the name of the coil&apos;s pose there</source>
        <translation>追跡装置の OpenIGTLink サーバーと、そこでのコイルの姿勢の名前</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>name of the pose of the tool on the head, at the same server</source>
        <translation>頭に付けたツールの姿勢の、同じサーバーでの名前</translation>
    </message>
    <message>
        <source>second coil</source>
        <translation>第 2 コイル</translation>
    </message>
    <message>
        <source>name of the second coil&apos;s pose there; may stay empty</source>
        <translation>同じサーバーでの第 2 コイルの姿勢の名前。空欄でも構いません</translation>
    </message>
    <message>
        <source>Use this tracker</source>
        <translation>この追跡装置を使う</translation>
    </message>
    <message>
        <source>in place of cameras, from now on</source>
        <translation>今後、カメラの代わりに使います</translation>
    </message>
    <message>
        <source>other tracker: %1</source>
        <translation>別の追跡装置: %1</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>a file, or touch points below</source>
        <translation>ファイル、または下で点に触れる</translation>
    </message>
    <message>
        <source>JSON file: how the tool on the head stands to the MRI, and its error</source>
        <translation>JSON ファイル: 頭に付けたツールの MRI に対する姿勢と、その誤差</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>JSON file with mri_T_subject, or with points touched on the head</source>
        <translation>mri_T_subject、または頭で触れた点を含む JSON ファイル</translation>
    </message>
    <message>
        <source>Alignment of the tracker</source>
        <translation>追跡装置の位置合わせ</translation>
    </message>
    <message>
        <source>Alignment (*.json)</source>
        <translation>位置合わせ (*.json)</translation>
    </message>
    <message>
        <source>pointer</source>
        <translation>ポインター</translation>
    </message>
    <message>
        <source>name of the pointer&apos;s pose there; its origin is the tip</source>
        <translation>同じサーバーでのポインターの姿勢の名前。原点は先端です</translation>
    </message>
    <message>
        <source>error of a point?</source>
        <translation>1 点の誤差は?</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>error of a touched point</source>
        <translation>触れた点の誤差</translation>
    </message>
    <message>
        <source>root mean square error of one touched point: tracker, pointer and hand together</source>
        <translation>触れた 1 点の二乗平均平方根誤差: 追跡装置、ポインター、手を合わせた値</translation>
    </message>
    <message>
        <source>Align by points</source>
        <translation>点で位置合わせ</translation>
    </message>
    <message>
        <source>fits the touched points to the MRI and keeps them in the case</source>
        <translation>触れた点を MRI に合わせ、症例に保存します</translation>
    </message>
    <message>
        <source>hold the pointer&apos;s tip to this place, then press</source>
        <translation>ポインターの先端をこの場所に当ててから押してください</translation>
    </message>
    <message>
        <source>Touch: %1 %2</source>
        <translation>触れる: %1 %2</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TrackerPresenter</name>
    <message>
        <source>another tracker, %1</source>
        <translation>別の追跡装置、%1</translation>
    </message>
    <message>
        <source>not in use</source>
        <translation>使用していません</translation>
    </message>
    <message>
        <source>the tracker does not answer; it is asked again and again</source>
        <translation>追跡装置の応答がありません。問い合わせを繰り返しています</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>the coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>use the tracker first</source>
        <translation>先に追跡装置を使用してください (手順 1)</translation>
    </message>
    <message>
        <source>the pointer</source>
        <translation>ポインター</translation>
    </message>
    <message>
        <source>%1 is seen</source>
        <translation>%1が見えています</translation>
    </message>
    <message>
        <source>%1 is not seen</source>
        <translation>%1が見えません</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <translation>記録の読み込み</translation>
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
        <translation>頭の位置合わせ</translation>
    </message>
    <message>
        <source>ALIGNING: the face is measured and fitted to the scan</source>
        <translation>位置合わせ中: 顔を計測し、スキャンに合わせています</translation>
    </message>
    <message>
        <source>Going on with the session</source>
        <translation>セッションの再開</translation>
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
        <translation>追跡の開始</translation>
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
    <message>
        <source>ALIGNING: the tracker&apos;s alignment is read</source>
        <translation>位置合わせ中: 追跡装置の位置合わせを読み込んでいます</translation>
    </message>
    <message>
        <source>a second coil needs its name at the tracker (step 1), and that name a coil</source>
        <translation>第 2 コイルには追跡装置での名前 (手順 1) が必要です。名前がある場合は、第 2 コイルの選択が必要です</translation>
    </message>
</context>
<context>
    <name>facenav::ui::TreatSide</name>
    <message>
        <source>a pulse was given now</source>
        <translation>今、刺激しました</translation>
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
    <message>
        <source>tools</source>
        <translation>ツール</translation>
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
        <translation>カメラ 動きあり</translation>
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
    <message>
        <source>TRACKER on</source>
        <translation>追跡装置 動作中</translation>
    </message>
    <message>
        <source>TRACKER away</source>
        <translation>追跡装置 接続なし</translation>
    </message>
    <message>
        <source>target</source>
        <translation>標的</translation>
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
    <message>
        <source>filter of the worklist</source>
        <translation>ワークリストの絞り込み</translation>
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
        <translation>ワークリストの読み込み</translation>
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
<context>
    <name>report</name>
    <message>
        <source>changed_setting</source>
        <translation>変更した設定</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>alignment caution</source>
        <translation>位置合わせの注意</translation>
    </message>
    <message>
        <source>pain before</source>
        <translation>治療前の痛み</translation>
    </message>
    <message>
        <source>pain after</source>
        <translation>治療後の痛み</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>閾値</translation>
    </message>
    <message>
        <source>pulse source</source>
        <translation>パルスの入力元</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>stimulator</source>
        <translation>刺激装置</translation>
    </message>
    <message>
        <source>tip check</source>
        <translation>先端による確認</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Pulses not on target, or excluded</source>
        <translation>標的上でない、または除外されたパルス</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>status</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>%1 more: see pulses.csv</source>
        <translation>ほか %1 件: pulses.csv を参照してください</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>%1 more: see events.jsonl</source>
        <translation>ほか %1 件: events.jsonl を参照してください</translation>
    </message>
    <message>
        <source>The computer&apos;s clock was set back by %1 s during the session. Times of day jump there; the column t_s of pulses.csv does not</source>
        <translation>セッション中にコンピューターの時計が %1 s 戻されました。時刻はそこで不連続になりますが、pulses.csv の列 t_s は連続しています</translation>
    </message>
    <message>
        <source>The computer&apos;s clock was set forward by %1 s during the session. Times of day jump there; the column t_s of pulses.csv does not</source>
        <translation>セッション中にコンピューターの時計が %1 s 進められました。時刻はそこで不連続になりますが、pulses.csv の列 t_s は連続しています</translation>
    </message>
    <message>
        <source>back</source>
        <translation>後ろ</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>tier 0: a sphere fitted to the skull under the coil, usual error 28 %</source>
        <translation>段階 0: コイル直下の頭蓋骨に合わせた球、典型誤差 28 %</translation>
    </message>
    <message>
        <source>tier 1: scalp, skull and brain of the case, usual error 23 %</source>
        <translation>段階 1: 症例の頭皮、頭蓋骨、脳、典型誤差 23 %</translation>
    </message>
    <message>
        <source>tier 2: scalp, skull, fluid and brain of the case, usual error 19 %</source>
        <translation>段階 2: 症例の頭皮、頭蓋骨、髄液、脳、典型誤差 19 %</translation>
    </message>
    <message>
        <source>tier %1</source>
        <translation>段階 %1</translation>
    </message>
    <message>
        <source>median %1, 95th percentile %2 V/m (%3 pulses)</source>
        <translation>中央値 %1、95 パーセンタイル %2 V/m (パルス %3)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>At the target</source>
        <translation>標的での値</translation>
    </message>
    <message>
        <source>At the target, for a current that rises by 1 A/us</source>
        <translation>標的での値、電流変化率 1 A/us あたり</translation>
    </message>
    <message>
        <source>Largest on the cortex</source>
        <translation>皮質上の最大値</translation>
    </message>
    <message>
        <source>Largest on the cortex, for 1 A/us</source>
        <translation>皮質上の最大値、1 A/us あたり</translation>
    </message>
    <message>
        <source>Electric field</source>
        <translation>電場</translation>
    </message>
    <message>
        <source>Place of the largest, median</source>
        <translation>最大値の位置、中央値</translation>
    </message>
    <message>
        <source>Model of the head</source>
        <translation>頭部モデル</translation>
    </message>
    <message>
        <source>Field of the coil</source>
        <translation>コイルの電場</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>記載なし</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>記録なし</translation>
    </message>
    <message>
        <source>%1 % (%2 to %3), stated for %4 pulses</source>
        <translation>%1 % (%2～%3)、記載のあるパルス %4</translation>
    </message>
    <message>
        <source>no fixed rate</source>
        <translation>頻度の指定なし</translation>
    </message>
    <message>
        <source>%1 of %2 planned pulses were given</source>
        <translation>計画 %2 パルスのうち %1 パルスを照射しました</translation>
    </message>
    <message>
        <source>%1 are missing</source>
        <translation>%1 パルス不足</translation>
    </message>
    <message>
        <source>%1 too many</source>
        <translation>%1 パルス超過</translation>
    </message>
    <message>
        <source>%1. %2 of them were on target</source>
        <translation>%1。うち %2 パルスが標的上でした</translation>
    </message>
    <message>
        <source>%1 trains in place of %2</source>
        <translation>トレイン数 %1 (計画 %2)</translation>
    </message>
    <message>
        <source>%1 Hz in place of %2</source>
        <translation>%1 Hz (計画 %2)</translation>
    </message>
    <message>
        <source>%1 % of the output in place of %2</source>
        <translation>出力 %1 % (計画 %2)</translation>
    </message>
    <message>
        <source>Rhythm and intensity were as planned</source>
        <translation>リズムと強度は計画どおりでした</translation>
    </message>
    <message>
        <source>Not as planned: %1</source>
        <translation>計画との相違: %1</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Trains</source>
        <translation>トレイン</translation>
    </message>
    <message>
        <source>Frequency in a train</source>
        <translation>トレイン内の周波数</translation>
    </message>
    <message>
        <source>%1 Hz (median)</source>
        <translation>%1 Hz (中央値)</translation>
    </message>
    <message>
        <source>Pause between trains</source>
        <translation>トレイン間の休止</translation>
    </message>
    <message>
        <source>%1 s (median)</source>
        <translation>%1 s (中央値)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Intensity, of maximal output</source>
        <translation>強度 (最大出力比)</translation>
    </message>
    <message>
        <source>Intensity, of the motor threshold</source>
        <translation>強度 (運動閾値比)</translation>
    </message>
    <message>
        <source>Protocol against given</source>
        <translation>計画と実施の比較</translation>
    </message>
    <message>
        <source>%1, version %2. %3 %4</source>
        <translation>%1、バージョン %2。%3 %4</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>given</source>
        <translation>実施</translation>
    </message>
    <message>
        <source>%1 single pulse</source>
        <translation>単発パルス %1</translation>
    </message>
    <message>
        <source>%1 single pulses</source>
        <translation>単発パルス %1</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>%1 train, %2 pulses each on average, %3 Hz</source>
        <translation>トレイン %1、平均 %2 パルス、%3 Hz</translation>
    </message>
    <message>
        <source>%1 trains, %2 pulses each on average, %3 Hz</source>
        <translation>トレイン %1、平均 %2 パルス、%3 Hz</translation>
    </message>
    <message>
        <source>train</source>
        <translation>トレイン</translation>
    </message>
    <message>
        <source>trains</source>
        <translation>トレイン</translation>
    </message>
    <message>
        <source>pauses of %1 s (medians)</source>
        <translation>休止 %1 s (中央値)</translation>
    </message>
    <message>
        <source>The protocol&apos;s file cannot be read</source>
        <translation>プロトコルのファイルを読み込めません</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>No pulse was given at a target</source>
        <translation>標的でのパルス照射はありませんでした</translation>
    </message>
    <message>
        <source>%1 from anterior</source>
        <translation>前方から %1</translation>
    </message>
    <message>
        <source>%1 from superior</source>
        <translation>上方から %1</translation>
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
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>on the cortex, MRI (RAS mm)</source>
        <translation>皮質上の点、MRI (RAS mm)</translation>
    </message>
    <message>
        <source>coil&apos;s centre, MRI (RAS mm)</source>
        <translation>コイル中心、MRI (RAS mm)</translation>
    </message>
    <message>
        <source>handle (deg)</source>
        <translation>ハンドル (deg)</translation>
    </message>
    <message>
        <source>planned gap (mm)</source>
        <translation>計画の隙間 (mm)</translation>
    </message>
    <message>
        <source>%1 of it paused</source>
        <translation>うち一時停止 %1</translation>
    </message>
    <message>
        <source>the program did not run for %1 in between</source>
        <translation>途中でプログラムが %1 停止していました</translation>
    </message>
    <message>
        <source>no pulse has a pose</source>
        <translation>姿勢のあるパルスがありません</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>override</source>
        <translation>例外</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>%1 to %2 % of maximal output, stated for %3 pulses</source>
        <translation>最大出力の %1～%2 %、記載のあるパルス %3</translation>
    </message>
    <message>
        <source>%1, median / 95th percentile %2 / %3 uV, %4 of them entered after their pulse</source>
        <translation>%1、中央値 / 95 パーセンタイル %2 / %3 uV、うち後から入力 %4</translation>
    </message>
    <message>
        <source>median %1 mm</source>
        <translation>中央値 %1 mm</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1～%2 mm</translation>
    </message>
    <message>
        <source>95 % within %1</source>
        <translation>95 % が %1 以内</translation>
    </message>
    <message>
        <source>%1 (one standard error; 95 % not recorded)</source>
        <translation>%1 (標準誤差; 95 % は記録なし)</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>理由の記載なし</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>未終了</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>not signed off</source>
        <translation>未承認</translation>
    </message>
    <message>
        <source>%1, %2 (no longer valid)</source>
        <translation>%1、%2 (現在は無効)</translation>
    </message>
    <message>
        <source>here</source>
        <translation>院内</translation>
    </message>
    <message>
        <source>at home; the file came back on %1</source>
        <translation>在宅; ファイルの返却 %1</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>所要時間</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Gone on with</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>no</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Head model checked by</source>
        <translation>頭部モデルの確認者</translation>
    </message>
    <message>
        <source>Treated without a sign-off</source>
        <translation>承認なしの治療</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Pauses, with their reasons</source>
        <translation>一時停止とその理由</translation>
    </message>
    <message>
        <source>Pain before (0 to 10)</source>
        <translation>治療前の痛み (0～10)</translation>
    </message>
    <message>
        <source>Pain after (0 to 10)</source>
        <translation>治療後の痛み (0～10)</translation>
    </message>
    <message>
        <source>Adverse events</source>
        <translation>有害事象</translation>
    </message>
    <message>
        <source>Stimulation</source>
        <translation>刺激</translation>
    </message>
    <message>
        <source>Stimulator (make, model)</source>
        <translation>刺激装置 (製造元、型式)</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>コイル</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>Motor threshold (method, criterion, hits of all)</source>
        <translation>運動閾値 (方法、基準、全体中の反応数)</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>Trains (frequency, pulses, pauses)</source>
        <translation>トレイン (周波数、パルス、休止)</translation>
    </message>
    <message>
        <source>of these on target</source>
        <translation>うち標的上</translation>
    </message>
    <message>
        <source>outside the tolerance</source>
        <translation>許容範囲外</translation>
    </message>
    <message>
        <source>with head or coil lost</source>
        <translation>頭部またはコイルの追跡喪失中</translation>
    </message>
    <message>
        <source>given in a pause (never on target)</source>
        <translation>一時停止中の照射 (標的上には数えない)</translation>
    </message>
    <message>
        <source>excluded, with a reason</source>
        <translation>除外 (理由あり)</translation>
    </message>
    <message>
        <source>Double triggers, not counted</source>
        <translation>二重トリガー (数えない)</translation>
    </message>
    <message>
        <source>Alignment of MRI and head</source>
        <translation>MRI と頭部の位置合わせ</translation>
    </message>
    <message>
        <source>Error of the alignment at the target</source>
        <translation>標的での位置合わせ誤差</translation>
    </message>
    <message>
        <source>Cautions of the alignment</source>
        <translation>位置合わせの注意</translation>
    </message>
    <message>
        <source>Re-checks of the registration</source>
        <translation>位置合わせの再確認</translation>
    </message>
    <message>
        <source>Coil&apos;s tip held to the face, judged by a person</source>
        <translation>コイル先端を顔に当てた確認 (人による判断)</translation>
    </message>
    <message>
        <source>Distance of coil and target at the pulses, median / 95th percentile</source>
        <translation>パルス時のコイルと標的の距離、中央値 / 95 パーセンタイル</translation>
    </message>
    <message>
        <source>Tilt at the pulses, median / 95th percentile</source>
        <translation>パルス時の傾き、中央値 / 95 パーセンタイル</translation>
    </message>
    <message>
        <source>Pulses within %1 mm and %2 deg</source>
        <translation>%1 mm、%2 deg 以内のパルス</translation>
    </message>
    <message>
        <source>Time guided, without pauses</source>
        <translation>誘導時間 (一時停止を除く)</translation>
    </message>
    <message>
        <source>of this off target</source>
        <translation>うち標的外</translation>
    </message>
    <message>
        <source>of this with head or coil lost</source>
        <translation>うち頭部またはコイルの追跡喪失</translation>
    </message>
    <message>
        <source>Face lost / coil lost / faults</source>
        <translation>顔の追跡喪失 / コイルの追跡喪失 / 障害</translation>
    </message>
    <message>
        <source>%1 / %2 / %3 times</source>
        <translation>%1 / %2 / %3 回</translation>
    </message>
    <message>
        <source>Navigation accuracy</source>
        <translation>ナビゲーションの精度</translation>
    </message>
    <message>
        <source>Pulses against their targets</source>
        <translation>標的に対するパルス</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Where the coil&apos;s centre was</source>
        <translation>コイル中心の位置</translation>
    </message>
    <message>
        <source>Filled circle: on target. Open square: outside the tolerance. Grey cross: excluded, in no bar. Dashed: 2 mm, and the tolerance of tilt and place</source>
        <translation>塗りつぶした円: 標的上。白抜きの四角: 許容範囲外。灰色の×印: 除外、棒には含まない。破線: 2 mm、および傾きと位置の許容範囲</translation>
    </message>
    <message>
        <source>Where the pulses went</source>
        <translation>パルスの照射位置</translation>
    </message>
    <message>
        <source>TMS session report</source>
        <translation>TMS セッションレポート</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>%1 / %2 ページ</translation>
    </message>
    <message>
        <source>Case %1, %2, session %3</source>
        <translation>症例 %1、%2、セッション %3</translation>
    </message>
    <message>
        <source>Case %1, session %2</source>
        <translation>症例 %1、セッション %2</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>頭部</translation>
    </message>
    <message>
        <source>Nasion to inion</source>
        <translation>鼻根点から後頭結節まで</translation>
    </message>
    <message>
        <source>Between the preauricular points</source>
        <translation>左右の耳前点の間</translation>
    </message>
    <message>
        <source>Circumference</source>
        <translation>頭囲</translation>
    </message>
    <message>
        <source>Gap of the coil&apos;s centre to the skin (hair, hollows)</source>
        <translation>コイル中心と皮膚の隙間 (髪、くぼみ)</translation>
    </message>
    <message>
        <source>FaceNav %1. Not a medical device: for research and development</source>
        <translation>FaceNav %1。医療機器ではありません: 研究開発用です</translation>
    </message>
    <message>
        <source>target</source>
        <translation>標的</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>追跡装置</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>障害</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>範囲外</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>追跡喪失</translation>
    </message>
</context>
</TS>
