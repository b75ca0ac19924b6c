import type { Editor } from '../context/index.ts';
import { addLevels } from '../panels/levels/index.ts';
import { type Importing, importText } from '../share/index.ts';

/** A text that somebody chose, dropped or pasted. */
export interface GivenText {
  readonly name: string;
  readonly text: string;
}

type Refused = Extract<Importing, { ok: false }>;

const problemInWords = (name: string, { problems }: Refused): string => {
  const [{ line, column, message, hint }] = problems;
  const more = problems.length > 1 ? ` (and ${problems.length - 1} more)` : '';
  return `${name}${line === null ? '' : `:${line}:${column}`}: ${message}${more}. ${hint}`;
};

/** Files that must not be read into memory as levels, bytes. */
const LARGEST = 4 * 1024 * 1024;

/** Texts of files; what is too large to be a level is said and left out. */
export async function readFiles({ notices }: Editor, files: Iterable<File>): Promise<GivenText[]> {
  const texts: GivenText[] = [];
  for (const file of files) {
    if (file.size > LARGEST)
      notices.show('warning', `${file.name} is too large to be a level: ${Math.round(file.size / 1e6)} MB.`);
    else texts.push({ name: file.name, text: await file.text() });
  }
  return texts;
}

/**
 * Adds the levels of some texts to a folder and opens the first; says what was passed over and what is no level.
 * @returns how many levels were added
 */
export async function takeIn(editor: Editor, folder: string, texts: readonly GivenText[], recoil: boolean): Promise<number> {
  const { notices } = editor;
  const wanted: { stem: string; file: Extract<Importing, { ok: true }>['levels'][number]['file'] }[] = [];
  for (const { name, text } of texts) {
    const importing = importText(text, name, { recoil });
    if (!importing.ok) {
      notices.show('error', problemInWords(name, importing));
      continue;
    }
    wanted.push(...importing.levels.map(({ slug, file }) => ({ stem: slug, file })));
    for (const note of importing.notes) notices.show('info', `${name}: ${note}`);
  }
  if (wanted.length === 0) return 0;
  const { length } = await addLevels(editor, folder, wanted);
  if (length > 0) notices.show('info', length === 1 ? 'One level was imported.' : `${length} levels were imported.`);
  return length;
}
