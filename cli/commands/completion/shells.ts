import type { CommandWords, OptionWords, Taken } from './words.ts';

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

const quotedForFish = (text: string): string => `'${text.replace(/['\\]/g, '\\$&')}'`;

/** The part of a line that completes what an option or argument takes. */
function taking(taken: Taken): string {
  switch (taken.what) {
    case 'values':
      return ` -a ${quotedForFish(taken.values.join(' '))}`;
    case 'levels':
      return " -k -a '(__fish_complete_suffix .json)'";
    case 'files':
      return ' -F';
    case 'folders':
      return " -a '(__fish_complete_directories)'";
    case 'runs':
      return " -a '(__gq_runs)'";
    case 'anything':
      return '';
  }
}

/** The completion of gq for fish, 3.0 or newer. */
export function fishScript(commands: readonly CommandWords[]): string {
  let text = `# Completion of gq for fish; made by: gq completion fish

function __gq_runs
    for file in (commandline -opc)
        if string match -q '*.json' -- $file; and test -f $file
            sed -n '/"runs"/,$ s/.*"name": *"\\\\([^"\\\\\\\\]*\\\\)".*/\\\\1/p' $file
        end
    end
end

complete -c gq -e
complete -c gq -f
complete -c gq -n __fish_use_subcommand -s V -l version -d 'print the version'
complete -c gq -n __fish_use_subcommand -s h -l help -d 'show help'
`;
  for (const { name, about } of commands)
    text += `complete -c gq -n __fish_use_subcommand -a ${name} -d ${quotedForFish(about)}\n`;
  for (const { name, options, argument } of commands) {
    const start = `complete -c gq -n '__fish_seen_subcommand_from ${name}'`;
    if (argument !== null && taking(argument) !== '') text += `${start}${taking(argument)}\n`;
    for (const { flags, about, takes, isOptional } of options) {
      const names = flags.map((flag) => (flag.startsWith('--') ? ` -l ${flag.slice(2)}` : ` -s ${flag.slice(1)}`)).join('');
      // -x: needs a value, and no file unless it is one
      const value = takes === null ? '' : `${isOptional ? '' : takes.what === 'files' ? ' -r' : ' -x'}${taking(takes)}`;
      text += `${start}${names}${value} -d ${quotedForFish(about)}\n`;
    }
  }
  return text;
}

/** Text within a specification, in which brackets and colons mean something. */
const plain = (text: string): string => text.replace(/[\\[\]:]/g, '\\$&');

function action(taken: Taken): string {
  switch (taken.what) {
    case 'values':
      return `(${taken.values.join(' ')})`;
    case 'levels':
      return '_files -g "*.json"';
    case 'files':
      return '_files';
    case 'folders':
      return '_files -/';
    case 'runs':
      return '_gq_runs';
    case 'anything':
      return ' ';
  }
}

function optionSpecs({ flags, about, takes, isOptional }: OptionWords): string[] {
  // a value that may be left out is given with = only
  const sign = (flag: string): string => (takes === null ? '' : !flag.startsWith('--') ? '+' : isOptional ? '=-' : '=');
  const value = takes === null ? '' : `${isOptional ? '::' : ':'}value:${action(takes)}`;
  return flags.map((flag) => quoted(`*${flag}${sign(flag)}[${plain(about)}]${value}`));
}

/** The completion of gq for zsh. It works as a file _gq in a folder of fpath, and sourced. */
export function zshScript(commands: readonly CommandWords[]): string {
  const list = commands.map(({ name, about }) => `    ${quoted(`${name}:${plain(about)}`)}\n`).join('');
  const cases = commands.map(({ name, options, argument }) => {
    const specs = [
      ...options.flatMap(optionSpecs),
      ...(argument === null ? [] : [quoted(`*:${argument.what}:${action(argument)}`)]),
    ];
    return `    ${name})\n      _arguments -s \\\n        ${specs.join(' \\\n        ')}\n      ;;\n`;
  });
  return `#compdef gq
# Completion of gq for zsh; made by: gq completion zsh

_gq_runs() {
  local file
  local -a names
  for file in "\${words[@]}"; do
    if [[ $file == *.json && -f $file ]]; then
      names+=("\${(@f)$(sed -n '/"runs"/,$ s/.*"name": *"\\([^"\\\\]*\\)".*/\\1/p' "$file")}")
    fi
  done
  compadd -a names
}

_gq() {
  local -a commands
  commands=(
${list}  )
  if (( CURRENT == 2 )); then
    _describe -t commands 'command' commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
${cases.join('')}  esac
}

if [[ \${funcstack[1]} == _gq ]]; then
  _gq "$@"
else
  compdef _gq gq
fi
`;
}
