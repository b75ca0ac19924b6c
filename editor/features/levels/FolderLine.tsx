import { ChevronRight, Folder } from 'lucide-react';

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
