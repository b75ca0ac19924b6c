import type { CommandWords, Taken } from './words.ts';

const quoted = (text: string): string => `'${text.replace(/['\\]/g, '\\$&')}'`;

/** The part of a line that completes what an option or argument takes. */
function taking(taken: Taken): string {
  switch (taken.what) {
    case 'values':
      return ` -a ${quoted(taken.values.join(' '))}`;
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
  for (const { name, about } of commands) text += `complete -c gq -n __fish_use_subcommand -a ${name} -d ${quoted(about)}\n`;
  for (const { name, options, argument } of commands) {
    const start = `complete -c gq -n '__fish_seen_subcommand_from ${name}'`;
    if (argument !== null && taking(argument) !== '') text += `${start}${taking(argument)}\n`;
    for (const { flags, about, takes, isOptional } of options) {
      const names = flags.map((flag) => (flag.startsWith('--') ? ` -l ${flag.slice(2)}` : ` -s ${flag.slice(1)}`)).join('');
      // -x: needs a value, and no file unless it is one
      const value = takes === null ? '' : `${isOptional ? '' : takes.what === 'files' ? ' -r' : ' -x'}${taking(takes)}`;
      text += `${start}${names}${value} -d ${quoted(about)}\n`;
    }
  }
  return text;
}
