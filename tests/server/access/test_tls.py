"""Passwords and cookies on their way: TLS of our own, or a proxy that ends it and says so."""

from pathlib import Path

from bumpless_server.access.who import Role
from bumpless_server.keys.authority import new_authority, sign_party
from tests.server.access.people import NAMES, PASSWORD, Make, staffed

LOGIN = {"name": NAMES[Role.operator], "password": PASSWORD}


def certificate(folder: Path) -> dict[str, Path]:
    """Files of a server's key and its certificate, with the authority that a client must know."""
    authority = new_authority()
    server = sign_party(authority, "server", ("127.0.0.1",))
    cert, key = folder / "server.crt", folder / "server.key"
    cert.write_bytes(server.certificate + authority.certificate)
    key.write_bytes(server.key)
    return {"tls_cert": cert, "tls_key": key}


def test_a_server_with_a_certificate_speaks_tls_and_keeps_its_cookie_to_it(
    make_settings: Make, tmp_path: Path
) -> None:
    """Protects: nobody on the network reads a password or a cookie."""
    with staffed(make_settings(manage_node=False, **certificate(tmp_path))) as server:
        answer = server.http.post("/api/login", json=LOGIN)
        assert answer.status_code == 204 and "Secure" in answer.headers["set-cookie"]
        assert server.http.get("/api/me").json()["name"] == "otto"
        assert "max-age" in server.http.get("/api/me").headers["strict-transport-security"]


def test_a_named_proxy_says_how_and_from_where_a_request_came(make_settings: Make) -> None:
    """Protects: behind a proxy cookies are Secure, addresses are true, and plain HTTP is shut."""
    settings = make_settings(manage_node=False, proxies=("127.0.0.1",), allowed_hosts=("console.example",))
    with staffed(settings) as server:
        plain = server.http.post("/api/login", json=LOGIN)
        assert plain.status_code == 403 and "by HTTPS" in plain.json()["detail"]
        assert server.http.get("/api/health").status_code == 200
        came = {"host": "console.example", "x-forwarded-proto": "https", "x-forwarded-for": "10.9.8.7"}
        answer = server.http.post("/api/login", json=LOGIN, headers=came)
        assert answer.status_code == 204 and "Secure" in answer.headers["set-cookie"]
        assert server.console.audit.entries()[-1]["address"] == "10.9.8.7"


def test_nobody_else_can_say_so(make_settings: Make) -> None:
    """Protects: without a named proxy, a header makes no guess come from another address."""
    with staffed(make_settings(manage_node=False)) as server:
        came = {"x-forwarded-proto": "https", "x-forwarded-for": "10.9.8.7"}
        answer = server.http.post("/api/login", json=LOGIN, headers=came)
        assert answer.status_code == 204 and "Secure" not in answer.headers["set-cookie"]
        assert server.console.audit.entries()[-1]["address"] == "127.0.0.1"
