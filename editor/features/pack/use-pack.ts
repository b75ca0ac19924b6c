import { useEffect, useMemo } from 'react';
import { useStore } from 'zustand';
import type { Terms } from '../../../engine/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import { useEditor, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { type FolderPack, folderPackIn } from '../../core/files/index.ts';
import { factsOf, thumbnailKey, thumbnailsOf } from '../../core/levels/index.ts';
import { gradeOf, gradesOf } from './grades.ts';
import { modelOf, type PackModel } from './pack-model.ts';

const NO_LEVELS: readonly LevelEntry[] = [];

/** What the view of the pack is made of. */
export interface ShownPack {
  readonly model: PackModel;
  readonly pack: FolderPack;
  readonly levels: readonly LevelEntry[];
  readonly terms: Terms;
}

/** The pack of the folder; its levels are looked at while this is mounted. */
export function usePack(): ShownPack {
  const editor = useEditor();
  const { workspace } = editor;
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const levels = useStore(workspace.store, ({ list }) => list?.levels) ?? NO_LEVELS;
  const folder = useStore(workspace.store, ({ list }) => list?.folder.id) ?? '';
  const pack = useStore(workspace.store, folderPackIn);
  const thumbnails = thumbnailsOf(editor);
  const grades = gradesOf(editor);
  const facts = useStore(thumbnails.store, (made) => made.facts);
  const graded = useStore(grades.store, (state) => state.byKey);

  useEffect(() => {
    const valid = levels.filter(({ status }) => status === 'valid');
    // the last one that is wanted is made first
    for (const entry of valid.toReversed()) thumbnails.want(entry, theme, terms);
    return () => {
      for (const entry of valid) thumbnails.drop(thumbnailKey(entry, theme, terms) ?? '');
    };
  }, [thumbnails, levels, theme, terms]);
  // while nobody looks, nothing is measured
  useEffect(() => grades.stop, [grades]);

  const model = useMemo(() => {
    void facts;
    void graded;
    return modelOf({
      levels,
      pack,
      factsOf: (entry) => factsOf(thumbnails.store.getState(), entry, terms),
      gradeOf: (entry) => gradeOf(grades.store.getState(), folder, entry, terms),
    });
  }, [levels, pack, facts, graded, folder, terms, thumbnails, grades]);
  return { model, pack, levels, terms };
}
