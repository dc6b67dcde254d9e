// Shapes that carry status beside colour. All 16 x 16, drawn with the current colour.
import type { ComponentChildren } from "preact";

function icon(children: ComponentChildren, filled = false) {
  return function Icon({ size = 14 }: { size?: number }) {
    return (
      <svg
        class="icon"
        width={size}
        height={size}
        viewBox="0 0 16 16"
        fill={filled ? "currentColor" : "none"}
        stroke={filled ? "none" : "currentColor"}
        stroke-width="1.7"
        stroke-linecap="round"
        stroke-linejoin="round"
        aria-hidden="true"
      >
        {children}
      </svg>
    );
  };
}

export const InfoIcon = icon(
  <>
    <circle cx="8" cy="8" r="6" />
    <path d="M8 7.4v3.4M8 5v.2" />
  </>,
);
export const WarningIcon = icon(
  <>
    <path d="M8 2 14.6 13.6H1.4Z" />
    <path d="M8 6.4v3.2M8 11.6v.1" />
  </>,
);
export const AlarmIcon = icon(
  <>
    <path d="M5.2 1.5h5.6l3.7 3.7v5.6l-3.7 3.7H5.2l-3.7-3.7V5.2Z" />
    <path d="M8 4.6v4.2M8 11.2v.1" />
  </>,
);
export const CheckIcon = icon(<path d="m3 8.6 3.2 3.2L13 4.6" />);
export const CrossIcon = icon(<path d="m4 4 8 8M12 4l-8 8" />);
export const PlayIcon = icon(<path d="M4 2.5v11l9.5-5.5Z" />, true);
export const PauseIcon = icon(<path d="M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z" />, true);
export const StopIcon = icon(<path d="M5 1.5h6L14.5 5v6L11 14.5H5L1.5 11V5Z" />, true);
export const RecordIcon = icon(<circle cx="8" cy="8" r="5" />, true);
export const HollowIcon = icon(<circle cx="8" cy="8" r="4.6" />);
export const DownloadIcon = icon(<path d="M8 2v8M4.6 7 8 10.4 11.4 7M2.5 13.5h11" />);
export const UploadIcon = icon(<path d="M8 10.6V2.4M4.6 5.6 8 2.2l3.4 3.4M2.5 13.5h11" />);
export const RiseIcon = icon(<path d="M8 13.6V5.4M4.6 8.6 8 5.2l3.4 3.4M2.2 2.4h11.6" />);
export const UndoIcon = icon(<path d="M5.5 3 2.5 6l3 3M2.8 6H10a3.6 3.6 0 0 1 0 7.2H7" />);
export const RedoIcon = icon(<path d="m10.5 3 3 3-3 3M13.2 6H6a3.6 3.6 0 0 0 0 7.2h3" />);
export const TrashIcon = icon(<path d="M2.5 4h11M6 4V2.4h4V4M4 4l.7 9.6h6.6L12 4" />);
export const SunIcon = icon(
  <>
    <circle cx="8" cy="8" r="3" />
    <path d="M8 1.2v1.4M8 13.4v1.4M1.2 8h1.4M13.4 8h1.4M3.2 3.2l1 1M11.8 11.8l1 1M12.8 3.2l-1 1M4.2 11.8l-1 1" />
  </>,
);
export const MoonIcon = icon(<path d="M13.5 9.6A6 6 0 0 1 6.4 2.5a6 6 0 1 0 7.1 7.1Z" />);
export const TriangleIcon = icon(<path d="M8 2.5 14.5 13h-13Z" />, true);
export const DiamondIcon = icon(<path d="M8 1.8 14.2 8 8 14.2 1.8 8Z" />);
export const FindIcon = icon(
  <>
    <circle cx="7" cy="7" r="4.4" />
    <path d="m10.4 10.4 3.6 3.6" />
  </>,
);
export const BellIcon = icon(
  <path d="M3 11.5h10c-1.2-1-1.5-2-1.5-4.5a3.5 3.5 0 0 0-7 0c0 2.5-.3 3.5-1.5 4.5ZM7 13.8h2" />,
);
export const BellOffIcon = icon(
  <path d="M3 11.5h10c-1.2-1-1.5-2-1.5-4.5a3.5 3.5 0 0 0-7 0c0 2.5-.3 3.5-1.5 4.5ZM2 2l12 12" />,
);
export const ClockIcon = icon(
  <>
    <circle cx="8" cy="8" r="6" />
    <path d="M8 4.6V8l2.4 1.6" />
  </>,
);
export const RefreshIcon = icon(<path d="M13.2 8A5.2 5.2 0 1 1 11.6 4.2M13.4 2v3h-3" />);
