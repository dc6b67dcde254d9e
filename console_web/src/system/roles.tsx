// The roles there are, and the field that chooses one.
export const ROLES = ["observer", "operator", "engineer"] as const;
export type Role = (typeof ROLES)[number];

const ABOUT: Record<Role, string> = {
  observer: "sees everything",
  operator: "also commands",
  engineer: "also changes parameters and accounts",
};

interface RoleFieldProps {
  label: string;
  value: Role;
  small?: boolean;
  onChoose: (role: Role) => void;
}

export function RoleField({ label, value, small, onChoose }: RoleFieldProps) {
  return (
    <select
      aria-label={label}
      class={small ? "small" : undefined}
      value={value}
      onChange={(event) => onChoose(event.currentTarget.value as Role)}
    >
      {ROLES.map((role) => (
        <option key={role} value={role}>
          {small ? role : `${role}: ${ABOUT[role]}`}
        </option>
      ))}
    </select>
  );
}
