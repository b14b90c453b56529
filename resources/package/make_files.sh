#!/usr/bin/env bash
# make_files.sh BIN OUT VERSION MAINTAINER: the files of the packages that come from the programs in BIN: man pages,
# completion, changelog, list of parts (SPDX). OUT/clinic and OUT/lab become /usr/share.
set -eu -o pipefail
bin=$1 out=$2 version=$3 maintainer=$4
source=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clinic=$out/clinic lab=$out/lab
rm -rf "$out"
mkdir -p "$clinic"/{man/man1,bash-completion/completions,zsh/vendor-completions,doc/facenav} "$lab"/{man/man1,doc/facenav-lab}
export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git -C "$source" log -1 --format=%ct 2>/dev/null || date +%s)}"

# A page of a program that has only --help: NAME, one line, and the help as it is printed.
page() {  # PROGRAM DESCRIPTION
  printf '.TH "%s" 1 "" "FaceNav %s"\n.SH NAME\n%s \\- %s\n.SH SYNOPSIS\n.B %s\n[OPTIONS]\n.SH DESCRIPTION\n.nf\n' \
    "$1" "$version" "$1" "$2" "$1"
  "$bin/$1" --help | sed -e '1,2d' -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"
  printf '.fi\n.SH EXIT STATUS\n0 done, 1 failed, 2 wrong usage.\n.SH SEE ALSO\n.BR facenav (1)\n'
}

"$bin/facenav-cli" help --man-pages "$clinic/man/man1" --quiet
page facenav-gui 'the workstation window' >"$clinic/man/man1/facenav-gui.1"
page facenav-bids 'prepares every T1w image of a BIDS dataset' >"$clinic/man/man1/facenav-bids.1"
printf '.so man1/facenav.1\n' >"$clinic/man/man1/facenav-cli.1"
"$bin/facenav-lab" help --man-pages "$out/lab_pages" --quiet
for verb in simulate evaluate demo; do
  rm -f "$clinic/man/man1/facenav-$verb".1
  cp "$out/lab_pages/facenav-$verb".1 "$out/lab_pages/facenav-$verb"-*.1 "$lab/man/man1/" 2>/dev/null || cp "$out/lab_pages/facenav-$verb".1 "$lab/man/man1/"
done
rm -rf "$out/lab_pages"
printf '.so man1/facenav.1\n' >"$lab/man/man1/facenav-lab.1"
gzip -9n "$clinic"/man/man1/*.1 "$lab"/man/man1/*.1

"$bin/facenav-cli" help --completion bash >"$clinic/bash-completion/completions/facenav"
"$bin/facenav-cli" help --completion zsh >"$clinic/zsh/vendor-completions/_facenav"
"$bin/facenav-cli" licences --spdx -o "$clinic/doc/facenav/facenav.spdx.json" --quiet

commit=$("$bin/facenav" --version | sed 's/.*commit \(.*\))/\1/')
date=$(LC_ALL=C date -u -R -d "@$SOURCE_DATE_EPOCH")
for package in clinic/doc/facenav lab/doc/facenav-lab; do
  sed -e "s/@VERSION@/$version/" -e "s/@COMMIT@/$commit/" -e "s/@DATE@/$date/" -e "s/@MAINTAINER@/$maintainer/" \
    "$source/changelog.in" >"$out/$package/changelog"
  gzip -9n "$out/$package/changelog"
  cp "$source/copyright" "$out/$package/copyright"
done
chmod -R u=rwX,go=rX "$out"
