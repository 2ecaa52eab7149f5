# Reads manuals and prints a line for each thing to check, its fields divided by tabs:
#   command FILE LINE WHEN TEXT     a command of a block of sh; WHEN is "always", or "ci"
#   skip    FILE LINE REASON        a block that is not run
#   link    FILE LINE TARGET        a link or a picture, but for addresses
#   heading FILE LINE ANCHOR        what a link may name behind #
#   error   FILE LINE SENTENCE
function say(kind, line, text) { print kind "\t" FILENAME "\t" line "\t" text }

# The word that GitHub makes of a heading.
function anchor(text) {
    gsub(/[^A-Za-z0-9 _-]/, "", text)
    gsub(/ /, "-", text)
    return tolower(text)
}

function links(text, line, target) {
    gsub(/`[^`]*`/, "", text)
    while (match(text, /\]\([^)]*\)|src="[^"]*"|href="[^"]*"/)) {
        target = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        sub(/^(\]\(|src="|href=")/, "", target)
        sub(/["\)]$/, "", target)
        sub(/ .*/, "", target)
        if (target !~ /^(https?|mailto):/) say("link", line, target)
    }
}

function run(text, line) {
    sub(/^ +/, "", text)
    if (text == "" || text ~ /^#/) return
    if (when == "not run") {
        ++not_run
        return
    }
    if (text ~ /^(app\/run|tests\/run|tests\/peers\/run|git|cmake|apt-get|sudo)( |$)/)
        say("error", line, "\"" text "\" builds or installs; mark its block with <!-- not run: REASON -->.")
    else
        say("command", line, when "\t" text)
}

FNR == 1 {
    if (in_block) print "error\t" last_file "\t" opened "\tthe block has no end."
    in_block = 0
    marker = ""
    last_file = FILENAME
}
!in_block && /^ *```/ {
    in_block = 1
    opened = FNR
    language = $0
    sub(/^ *```/, "", language)
    if (language ~ /^(bash|shell|console|zsh)/) say("error", FNR, "a block of commands is marked sh, not " language ".")
    when = "always"
    if (marker != "") {
        if (language != "sh") say("error", FNR - 1, "the mark is not followed by a block of sh.")
        if (marker ~ /^<!-- not run: /) {
            when = "not run"
            reason = marker
            sub(/^<!-- not run: /, "", reason)
            sub(/ *-->.*/, "", reason)
            if (language == "sh") say("skip", FNR, reason)
        } else
            when = "ci"
    }
    marker = ""
    text = ""
    next
}
in_block && /^ *```$/ { in_block = 0; next }
in_block {
    if (language != "sh") next
    if (text == "") began = FNR
    text = text $0
    # A command goes on behind a backslash.
    if (sub(/\\$/, "", text)) next
    run(text, began)
    text = ""
    next
}
{
    if (marker != "") say("error", FNR - 1, "the mark is not followed by a block of sh.")
    marker = ""
    if (/^<!-- *(not run|run in CI)/) {
        marker = $0
        if (marker !~ /^<!-- (not run|run in CI): [^ ].* -->$/) say("error", FNR, "a mark is <!-- not run: REASON --> or <!-- run in CI: REASON -->.")
        next
    }
    if (/^#+ /) {
        heading = $0
        sub(/^#+ +/, "", heading)
        say("heading", FNR, anchor(heading))
    }
    links($0, FNR)
}
END { if (in_block) print "error\t" last_file "\t" opened "\tthe block has no end." }
