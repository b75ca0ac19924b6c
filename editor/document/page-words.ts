/** What a level file's lists are of. */
const ONE_OF: Readonly<Record<string, string>> = {
  asteroids: 'asteroid',
  novae: 'nova',
  repulsors: 'repulsor',
  aliens: 'alien',
  minerals: 'mineral',
  runs: 'run',
};

/** A text in quotes, which is left alone; an entry of a list, with its kind before it or not, and what of it; or one of the two that are in no list. */
const NAMES =
  /"(?:[^"\\]|\\.)*"|(?:\b((?:hot )?asteroid|nova|alien) )?(?<![\w.\]])(asteroids|novae|repulsors|aliens|minerals|runs)\[(\d+)\]((?:\.[\w-]+|\[\d+\])*)|(?<![\w.\]])(astronaut|blackHole)((?:\.[\w-]+)+|(?=:))/g;

/** `.holds[2][1]` is `, hold 3, release` */
function partInWords(part: string): string {
  return part
    .replace(/\.holds\[(\d+)\]/, (_, hold: string) => `, hold ${Number(hold) + 1}`)
    .replace('[0]', ', press')
    .replace('[1]', ', release')
    .replaceAll('.', ', ');
}

/**
 * A message about a level file as the page says it: `asteroids[3].radius: expected …` becomes `asteroid 4, radius: expected …`. The command line
 * names what stands in a file, where lists count from 0; the page names what is seen.
 */
export function inPageWords(message: string): string {
  return message.replace(
    NAMES,
    (all: string, kind?: string, list?: string, index?: string, part?: string, single?: string, partOfSingle?: string) => {
      if (list !== undefined) return `${kind ?? ONE_OF[list]} ${Number(index) + 1}${partInWords(part ?? '')}`;
      if (single !== undefined) return `${single === 'blackHole' ? 'black hole' : single}${partInWords(partOfSingle ?? '')}`;
      return all;
    },
  );
}
