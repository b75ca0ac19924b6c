import type { CommandWords, Taken } from './words.ts';

const quoted = (text: string): string => `'${text.replaceAll("'", "'\\''")}'`;

/** The call that completes what an option or argument takes. */
function complete(taken: Taken | null): string {
  if (taken === null) return ':';
  switch (taken.what) {
    case 'values':
      return `_gq_words ${quoted(taken.values.join(' '))}`;
    case 'levels':
      return '_gq_files json';
    case 'files':
      return "_gq_files ''";
    case 'folders':
      return '_gq_files /';
    case 'runs':
      return '_gq_runs';
    case 'anything':
      return ':';
  }
}

/** The completion of gq for bash, 3.2 or newer. It needs no other program than sed. */
export function bashScript(commands: readonly CommandWords[]): string {
  const names = commands.map(({ name }) => name).join(' ');
  const values = commands.flatMap(({ name, options }) =>
    options.flatMap(({ flags, takes, isOptional }) =>
      takes === null
        ? []
        : [
            // a value that may be left out is only completed after =, or the next word would be taken for it
            `    ${flags
              .flatMap((flag) => (isOptional ? [] : [`${name}:${flag}`]))
              .concat(flags.map((flag) => `${name}:${flag}=`))
              .map(quoted)
              .join('|')}) ${complete(takes)}; return ;;\n`,
          ],
    ),
  );
  const rest = commands.map(({ name, options, argument }) => {
    const flags = options.flatMap((option) => option.flags).join(' ');
    return `    ${name}) if [[ $cur == -?* ]]; then _gq_words ${quoted(flags)}; else ${complete(argument)}; fi ;;\n`;
  });
  return `# Completion of gq for bash; made by: gq completion bash

_gq_words() {
  local word
  for word in $1; do
    if [[ $word == "$cur"* ]]; then COMPREPLY+=("$word"); fi
  done
}

# $1: json for folders and files of that ending, / for folders, else all files
_gq_files() {
  local path ending=$1
  compopt -o filenames 2>/dev/null
  while IFS= read -r path; do
    if [[ -d $path || $ending == '' || ( $ending == json && $path == *.json ) ]]; then COMPREPLY+=("$path"); fi
  done < <(compgen -f -- "\${cur//\\\\/}")
}

# the names of the runs in the level file among the words
_gq_runs() {
  local file name quoted
  for file in "\${COMP_WORDS[@]}"; do
    if [[ $file == *.json && -f $file ]]; then
      while IFS= read -r name; do
        printf -v quoted '%q' "$name"
        if [[ $quoted == "$cur"* || $name == "$cur"* ]]; then COMPREPLY+=("$quoted"); fi
      done < <(sed -n '/"runs"/,$ s/.*"name": *"\\([^"\\\\]*\\)".*/\\1/p' "$file")
    fi
  done
}

_gq() {
  local cur=\${COMP_WORDS[COMP_CWORD]} option=
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    _gq_words ${quoted(`${names} -h --help -V --version`)}
    return
  fi
  # readline makes a word of its own of =
  if [[ $cur == = ]]; then
    cur= option=\${COMP_WORDS[COMP_CWORD-1]}=
  elif [[ $COMP_CWORD -gt 2 && \${COMP_WORDS[COMP_CWORD-1]} == = ]]; then
    option=\${COMP_WORDS[COMP_CWORD-2]}=
  else
    option=\${COMP_WORDS[COMP_CWORD-1]}
  fi
  case "\${COMP_WORDS[1]}:$option" in
${values.join('')}  esac
  case "\${COMP_WORDS[1]}" in
${rest.join('')}  esac
}

complete -F _gq gq
`;
}
