import { type KeptAnswers, keepAnswers, question, type Wanted } from '../ask/index.ts';
import type { Editor } from '../context/index.ts';
import { keptWith } from '../kept/index.ts';
import { termsKey } from '../terms/index.ts';
import { type AskedOf, jobs, type LevelFacts, type Thumbnail } from '../workers/index.ts';

/** The text of a level file, and how it is drawn and judged. */
export type Drawing = AskedOf<typeof jobs.thumbnail>;

/** A small picture of a level file, and its verdict. */
export const pictureQuestion = question({
  job: jobs.thumbnail,
  request: (of: Drawing) => of,
  follows: {
    wait: { rest: 0 },
    of: (wanted: Wanted<Drawing>) => wanted.getState(),
    same: (asked, now) => asked === now,
    on: (wanted) => [wanted.subscribe],
  },
});

/** A picture that was made. */
export interface Picture {
  /** URL of an SVG; null if the level can't be drawn. */
  readonly url: string | null;
  readonly verdict: Thumbnail['verdict'];
}

/** A picture that is wanted. */
export interface WantedPicture extends Omit<Drawing, 'text'> {
  /** Reads the file; null: it is no longer what the key says. */
  readonly text: () => Promise<string | null>;
  /** Called with what the level has for players once it is drawn; null for a file that is no valid level. */
  readonly onDrawn?: (facts: LevelFacts | null) => void;
}

/** Number of pictures kept, some 30 kB each. */
const KEPT = 900;

/** Everything that a picture depends on, as a key. @param content a name of the file's content */
export const pictureKey = (content: string, { terms, theme, width }: Omit<Drawing, 'text'>): string =>
  `${content} ${theme} ${width} ${termsKey(terms)}`;

export const urlOf = (svg: string): string | null =>
  svg === '' ? null : URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));

/** The pictures of this page, by content: of levels and of their versions. What came into view last is drawn first. */
export const picturesOf = keptWith(
  ({ desk }: Pick<Editor, 'desk'>): KeptAnswers<WantedPicture, Picture> =>
    keepAnswers(desk, {
      ask: pictureQuestion,
      async of({ text, terms, theme, width }) {
        const read = await text();
        return read === null ? null : { text: read, terms, theme, width };
      },
      value({ answer, gaveUp }, { onDrawn }): Picture | null {
        if (answer === null && !gaveUp) return null;
        onDrawn?.(answer?.facts ?? null);
        return answer === null ? { url: null, verdict: 'unproven' } : { url: urlOf(answer.svg), verdict: answer.verdict };
      },
      first: 'latest',
      most: KEPT,
      leaves: ({ url }) => url !== null && URL.revokeObjectURL(url),
    }),
);
