import { ChevronRight, FileX, Folder, Lock } from 'lucide-react';
import { useEffect } from 'react';
import { useStore } from 'zustand';
import type { LevelEntry } from '../../../schema/index.ts';
import { type OpenLevel, useEditor, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { problemsInWords } from '../../core/files/index.ts';
import {
  type ListedVerdict,
  pictureOf,
  stemOf,
  thumbnailKey,
  thumbnailsOf,
  VerdictSign,
  verdictOf,
} from '../../core/levels/index.ts';
import { isOtherAccuracy } from '../../core/terms/index.ts';
import { MoreButton } from '../../core/tree/index.ts';
import { useVerdict } from '../../core/verdict/index.ts';

/** The thumbnail and the verdict of a listed level, made while its row is visible. */
function useThumbnail(entry: LevelEntry): { readonly url: string | null; readonly verdict: ListedVerdict } {
  const editor = useEditor();
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const thumbnails = thumbnailsOf(editor);
  const key = thumbnailKey(entry, theme, terms);
  const url = useStore(thumbnails.store, (made) => pictureOf(made, entry, theme, terms));
  const verdict = useStore(thumbnails.store, (made) => verdictOf(made, entry, terms));
  useEffect(() => {
    if (entry.status !== 'valid' || key === null) return;
    thumbnails.want(entry, theme, terms);
    return () => thumbnails.drop(key);
  }, [thumbnails, entry, theme, terms, key]);
  return { url, verdict: entry.status === 'valid' ? (verdict ?? 'unknown') : entry.status };
}

function LiveVerdict({ level }: { level: OpenLevel }) {
  const { verdict } = useVerdict(level);
  return <VerdictSign verdict={verdict} />;
}

function LiveName({ level }: { level: OpenLevel }) {
  return useStore(level.document.store, ({ file }) => file.name);
}

/** Where its file can't be read: `4:3 `. */
function placeOf({ problems: [first] }: LevelEntry): string {
  return first === undefined || first.line === null ? '' : `${first.line}:${first.column} `;
}

/**
 * A level in the list: its picture, name and the verdict of `gq check`; live for the open level, unless that is shown at another
 * accuracy. @param open the level if it is open, else null
 */
export function LevelLine({ entry, title, open }: { entry: LevelEntry; title: string; open: OpenLevel | null }) {
  const { url, verdict } = useThumbnail(entry);
  const isOther = isOtherAccuracy(usePageTerms());
  const wrong = entry.problems.length === 0 ? null : entry.problems[0].message;
  const number = entry.name === null ? undefined : /^\d+(?=[ ._-])/.exec(stemOf(entry.id))?.[0];
  return (
    <>
      <span className="levels__picture">
        {entry.status !== 'valid' ? <FileX size={18} aria-hidden /> : url !== null && <img src={url} alt="" draggable={false} />}
      </span>
      <span className="levels__text">
        <span className="levels__line">
          {number !== undefined && <span className="levels__number numbers">{number}</span>}
          <span className="levels__name">{open === null ? title : <LiveName level={open} />}</span>
        </span>
        <span className="levels__file">
          {open === null || isOther || entry.status !== 'valid' ? (
            <VerdictSign verdict={verdict} />
          ) : (
            <LiveVerdict level={open} />
          )}
          {entry.readOnly !== null && (
            <span className="levels__lock" role="img" aria-label={`read-only: ${entry.readOnly}`} title={entry.readOnly}>
              <Lock size={11} />
            </span>
          )}
          {entry.status === 'valid' ? (
            <span className="levels__stem levels__stem--file" title={entry.file}>
              {stemOf(entry.id)}
            </span>
          ) : (
            <span className="levels__stem" title={problemsInWords(entry.file, entry.problems)}>
              {placeOf(entry)}
              {wrong ?? entry.file}
            </span>
          )}
        </span>
      </span>
      <MoreButton />
    </>
  );
}

interface FolderLineProps {
  readonly title: string;
  readonly isOpen: boolean;
  /** The number of levels in the folder. */
  readonly count: number;
}

/** A folder in the list of levels. */
export function FolderLine({ title, isOpen, count }: FolderLineProps) {
  return (
    <>
      <ChevronRight size={13} className={`levels__fold${isOpen ? ' levels__fold--open' : ''}`} aria-hidden />
      <Folder size={14} aria-hidden />
      <span className="levels__name">{title}</span>
      <span className="levels__count numbers">
        {count}
        <span className="unseen">{count === 1 ? ' level' : ' levels'}</span>
      </span>
    </>
  );
}
