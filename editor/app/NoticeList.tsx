import { CircleAlert, Info, TriangleAlert, X } from 'lucide-react';
import { useEffect } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../core/context/index.ts';
import type { Notice } from '../core/notices/index.ts';
import { Button } from '../core/ui/index.ts';

const ICONS = { info: Info, warning: TriangleAlert, error: CircleAlert } as const;

/** ms that an information stays; warnings and errors stay until they are dismissed */
const STAY = 6000;

function NoticeCard({ notice }: { notice: Notice }) {
  const { notices } = useEditor();
  const Icon = ICONS[notice.severity];
  const passing = notice.severity === 'info' && notice.actions.length === 0;
  useEffect(() => {
    if (!passing) return;
    const timer = setTimeout(() => notices.dismiss(notice.id), STAY);
    return () => clearTimeout(timer);
  }, [passing, notice.id, notices]);
  return (
    <li className={`notice notice--${notice.severity}`}>
      <Icon size={16} aria-label={notice.severity} />
      <span className="notice__text">{notice.text}</span>
      {notice.actions.map(({ title, run }) => (
        <Button
          key={title}
          hint={title}
          look="outlined"
          onClick={() => {
            notices.dismiss(notice.id);
            run();
          }}
        >
          {title}
        </Button>
      ))}
      <Button hint="Dismiss" icon={<X size={14} />} onClick={() => notices.dismiss(notice.id)} />
    </li>
  );
}

/** The editor's messages, in a corner of the page and read out by screen readers. */
export function NoticeList() {
  const { notices } = useEditor();
  const list = useStore(notices.store);
  return (
    <ul className="notices" aria-live="polite" aria-label="Messages">
      {list.map((notice) => (
        <NoticeCard key={notice.id} notice={notice} />
      ))}
    </ul>
  );
}
