import { Bookmark, HardDrive } from 'lucide-react';
import { useEffect, useMemo } from 'react';
import { useStore } from 'zustand';
import { useEditor, useLevel, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { VerdictSign } from '../../core/levels/index.ts';
import { picturesOf } from '../../core/pictures/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { versionKey, wantPicture } from './version-pictures.ts';
import { stepsInWords } from './version-rows.ts';
import { agoInWords, clockTime } from './when.ts';

/** A version in the list: its picture, time, steps, name and verdict. */
export function VersionLine({ version, now }: { readonly version: Version; readonly now: number }) {
  const editor = useEditor();
  const level = useLevel();
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const by = useMemo(() => ({ theme, terms }), [theme, terms]);
  const pictures = picturesOf(editor);
  const key = versionKey(version, by);
  const picture = useStore(pictures.store, ({ byKey }) => byKey.get(key)) ?? null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: a renamed version looks the same
  useEffect(() => {
    wantPicture(editor, level, version, by);
    return () => pictures.drop(key);
  }, [editor, level, pictures, key, by]);
  const steps = stepsInWords(version);
  // the first line has the most telling of the three, the second the next
  const [title, about] = [version.name, version.changes, steps].filter((words) => words !== null && words !== '');
  return (
    <>
      <span className="levels__picture">{picture?.url != null && <img src={picture.url} alt="" draggable={false} />}</span>
      <span className="history__text" title={[version.changes, steps].filter((words) => words !== '').join(' – ')}>
        <span className="history__line">
          {version.name !== null && <Bookmark size={12} aria-label="named" className="history__mark" />}
          {version.by === 'other' && <HardDrive size={12} aria-label="by another program" className="history__mark" />}
          <span className={version.name === null ? 'history__steps' : 'history__name'}>{title}</span>
        </span>
        {about !== undefined && <span className="history__line history__line--quiet history__about-line">{about}</span>}
        <span className="history__line history__line--quiet">
          <span className="numbers">{clockTime(version.time)}</span>
          <span>{agoInWords(version.time, now)}</span>
          {picture !== null && <VerdictSign verdict={picture.verdict} />}
        </span>
      </span>
    </>
  );
}
