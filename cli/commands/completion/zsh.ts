import type { CommandWords, OptionWords, Taken } from './words.ts';

const quoted = (text: string): string => `'${text.replaceAll("'", "'\\''")}'`;

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
